#pragma once

#include "solver/engine/contacts.hpp"

namespace recoat {

/// Contacts of a list that has been replaced, without ownership: those of the particles from `begin` on, `particles` of
/// them, by their places then.
struct OldContacts {
    std::int32_t begin, particles;
    const std::int32_t *offsets, *second;
    const double *slip_x, *slip_y, *slip_z, *attraction;

    RECOAT_HD bool has(std::int32_t place) const { return place >= begin && place - begin < particles; }

    /// The contact of the pair, whose first is of this list, or -1.
    RECOAT_HD std::int32_t pair(std::int32_t first, std::int32_t other) const {
        std::int32_t k = offsets[first - begin];
        const std::int32_t end = offsets[first - begin + 1];
        while (k < end && second[k] != other) ++k;
        return k < end ? k : -1;
    }
    /// The contact of particle and wall, or -1.
    RECOAT_HD std::int32_t wall(std::int32_t place, std::size_t wall) const {
        const std::size_t slot =
            static_cast<std::size_t>(particles) * (1 + wall) + static_cast<std::size_t>(place - begin);
        return offsets[slot + 1] > offsets[slot] ? offsets[slot] : -1;
    }
};

/// What the lists that are being replaced remember of their contacts.
template <class Space>
struct ContactHistory {
    template <class T>
    using Array = typename Space::template Array<T>;

    struct List {
        std::size_t begin = 0, particles = 0;
        Array<std::int32_t> offsets, second;
        Array<double> slip_x, slip_y, slip_z, attraction;

        /// Takes the list of the particles from `first` on, `count` of them.
        void take(Space& space, const ContactArrays<Space>& from, std::size_t first, std::size_t count) {
            begin = first;
            particles = count;
            space.copy(from.offsets, offsets);
            space.copy(from.second, second);
            space.copy(from.slip_x, slip_x);
            space.copy(from.slip_y, slip_y);
            space.copy(from.slip_z, slip_z);
            space.copy(from.attraction, attraction);
        }
        [[nodiscard]] OldContacts view() const {
            return {static_cast<std::int32_t>(begin),
                    static_cast<std::int32_t>(particles),
                    offsets.data(),
                    second.data(),
                    slip_x.data(),
                    slip_y.data(),
                    slip_z.data(),
                    attraction.data()};
        }
    };
    List awake, asleep;
};

}  // namespace recoat
