#pragma once

#include <vector>

#include "solver/contact/model.hpp"
#include "solver/engine/contacts.hpp"
#include "solver/engine/far_list.hpp"

namespace recoat {

/// What a close list is made from.
struct CloseListInput {
    const Row* position;
    std::size_t particles;
    const WallAnchor* wall;  ///< [walls]
    std::size_t walls;
    std::int64_t step;
    double time_step, y_period;
    double range;  ///< pairs and walls with separation below this are listed [m]
    bool cohesive, relative_rolling;
    const std::int32_t* old_place;  ///< [N] place of each particle in the list before; null: the same

    [[nodiscard]] RECOAT_HD std::size_t slots() const { return particles * (1 + walls); }

    RECOAT_HD bool near_wall(std::size_t w, std::size_t i) const {
        const WallAnchor& from = wall[w];
        const Vec3 way = from.way(step, time_step);
        const Row p = load(position, i);
        const double separation = from.kind == WallKind::plane ? PlaneShape(from, way).meet(p.xyz(), p.w).separation
                                                               : BoxShape(from, way).meet(p.xyz(), p.w).separation;
        return from.active && separation < range;
    }
    RECOAT_HD std::int32_t before(std::int32_t i) const { return old_place ? old_place[i] : i; }
};

/// History of the contacts of a list, and where it is found.
template <class Space>
struct ContactHistory {
    template <class T>
    using Array = typename Space::template Array<T>;
    Array<std::int32_t> offsets, second;
    Array<double> slip_x, slip_y, slip_z, attraction;

    void take(Space& space, const ContactArrays<Space>& from) {
        space.copy(from.offsets, offsets);
        space.copy(from.second, second);
        space.copy(from.slip_x, slip_x);
        space.copy(from.slip_y, slip_y);
        space.copy(from.slip_z, slip_z);
        space.copy(from.attraction, attraction);
    }
};

/// Writes one contact of a new list, with what the old one remembers of it.
struct ContactWriter {
    CloseListInput in;
    std::int32_t *first, *second;
    ContactView to;
    const std::int32_t *old_offsets, *old_second;
    const double *old_x, *old_y, *old_z, *old_attraction;

    RECOAT_HD void pair(std::size_t k, std::int32_t i, std::int32_t j) const {
        // Where the partners change places, so does the sign of the first's displacement relative to the second.
        const std::int32_t a = in.before(i), b = in.before(j);
        const std::int32_t low = a < b ? a : b, high = a < b ? b : a;
        std::int32_t old = old_offsets[low];
        const std::int32_t end = old_offsets[low + 1];
        while (old < end && old_second[old] != high) ++old;
        write(k, i, j, old < end ? old : -1, a < b ? 1 : -1);
    }
    RECOAT_HD void wall(std::size_t k, std::int32_t i, std::size_t w) const {
        const std::size_t slot = in.particles * (1 + w) + static_cast<std::size_t>(in.before(i));
        const std::int32_t old = old_offsets[slot];
        write(k, i, -1 - static_cast<std::int32_t>(w), old_offsets[slot + 1] > old ? old : -1, 1);
    }

private:
    RECOAT_HD void write(std::size_t k, std::int32_t i, std::int32_t j, std::int32_t old, double sign) const {
        first[k] = i;
        second[k] = j;
        to.slip_x[k] = old < 0 ? 0 : sign * old_x[old];
        to.slip_y[k] = old < 0 ? 0 : sign * old_y[old];
        to.slip_z[k] = old < 0 ? 0 : sign * old_z[old];
        to.attraction[k] = old < 0 ? 0 : old_attraction[old];
        to.lost_normal[k] = to.lost_tangential[k] = to.wall_work[k] = 0;
    }
};

/// Counts what each particle has: pairs in which it is the first, and walls.
template <class Space>
void count_contacts(Space& space, const CloseListInput& in, const FarList<Space>& far,
                    typename Space::template Array<std::int32_t>& offsets) {
    offsets.resize(in.slots() + 1);
    std::int32_t* counts = offsets.data();
    const std::int32_t *begin = far.begin.data(), *partner = far.second.data();
    const Period period(in.y_period);
    space.for_each(in.slots() + 1, [=] RECOAT_LAMBDA(std::size_t slot) {
        std::int32_t count = 0;
        if (slot < in.particles) {
            const Row p = load(in.position, slot);
            for (std::int32_t e = begin[slot]; e < begin[slot + 1]; ++e)
                count += nearer(p, load(in.position, partner[e]), period, in.range);
        } else if (slot < in.slots()) {
            count = in.near_wall(slot / in.particles - 1, slot % in.particles);
        }
        counts[slot] = count;
    });
}

/// Fills in ContactArrays::offsets from the contacts themselves.
template <class Space>
void list_offsets(Space& space, ContactArrays<Space>& c, std::size_t particles, std::size_t walls) {
    const std::int32_t *first = c.first.data(), *second = c.second.data();
    const std::size_t slots = particles * (1 + walls);
    const auto slot = [=] RECOAT_LAMBDA(std::size_t k) {
        const std::size_t wall = second[k] < 0 ? static_cast<std::size_t>(-second[k]) : 0;
        return static_cast<std::int32_t>(particles * wall + static_cast<std::size_t>(first[k]));
    };
    typename Space::template Array<std::int32_t> entries;
    space.group(c.size(), slots, slot, c.offsets, entries);
}

/// Fills in which contacts every particle has.
template <class Space>
void list_incidence(Space& space, ContactArrays<Space>& c, std::size_t particles) {
    const std::int32_t *first = c.first.data(), *second = c.second.data();
    const auto none = static_cast<std::int32_t>(particles);
    const auto bucket = [=] RECOAT_LAMBDA(std::size_t entry) {
        const std::int32_t i = entry % 2 ? second[entry / 2] : first[entry / 2];
        return i < 0 ? none : i;
    };
    space.group(2 * c.size(), particles, bucket, c.incidence_begin, c.incidence);
}

/// Fills in what a saved list leaves out because it follows from the rest: where contacts are found, room for a step.
template <class Space>
void complete_list(Space& space, ContactArrays<Space>& c, const ContactModel& model, std::size_t particles,
                   std::size_t walls) {
    c.resize_scratch(model.hamaker > 0, model.rolling_form == RollingForm::relative);
    list_offsets(space, c, particles, walls);
    list_incidence(space, c, particles);
}

/// Lists the pairs that can touch or attract in the coming steps, and hands the history over to them; energies that
/// were counted are not carried over. `contacts.offsets` of the list before must be that of `input.old_place`.
template <class Space>
void make_close_list(Space& space, const CloseListInput& in, const FarList<Space>& far, ContactHistory<Space>& history,
                     ContactArrays<Space>& contacts) {
    history.take(space, contacts);
    count_contacts(space, in, far, contacts.offsets);
    space.exclusive_scan(contacts.offsets);
    const auto begins = space.picked(contacts.offsets, in.particles, in.particles, 1 + in.walls);
    contacts.wall_begin.assign(begins.begin(), begins.end());
    contacts.pairs = contacts.wall_begin.front();
    contacts.resize(contacts.wall_begin.back());
    const ContactWriter writer{in,
                               contacts.first.data(),
                               contacts.second.data(),
                               contacts.view(),
                               history.offsets.data(),
                               history.second.data(),
                               history.slip_x.data(),
                               history.slip_y.data(),
                               history.slip_z.data(),
                               history.attraction.data()};
    const std::int32_t *offsets = contacts.offsets.data(), *begin = far.begin.data(), *partner = far.second.data();
    const Period period(in.y_period);
    space.for_each(in.slots(), [=] RECOAT_LAMBDA(std::size_t slot) {
        auto k = static_cast<std::size_t>(offsets[slot]);
        if (slot < in.particles) {
            const Row p = load(in.position, slot);
            for (std::int32_t e = begin[slot]; e < begin[slot + 1]; ++e)
                if (nearer(p, load(in.position, partner[e]), period, in.range))
                    writer.pair(k++, static_cast<std::int32_t>(slot), partner[e]);
        } else if (offsets[slot + 1] > offsets[slot]) {
            writer.wall(k, static_cast<std::int32_t>(slot % in.particles), slot / in.particles - 1);
        }
    });
    // A processor adds contacts up while it goes through them.
    if constexpr (!Space::on_host) {
        contacts.resize_scratch(in.cohesive, in.relative_rolling);
        list_incidence(space, contacts, in.particles);
    }
}

}  // namespace recoat
