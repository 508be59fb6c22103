#pragma once

#include <vector>

#include "solver/contact/model.hpp"
#include "solver/engine/contact_history.hpp"
#include "solver/engine/contacts.hpp"
#include "solver/engine/far_list.hpp"
#include "solver/engine/wall_separation.hpp"

namespace recoat {

/// What a close list is made from. It is that of the particles from `begin` on, `particles` of them.
struct CloseListInput {
    const Row* position;
    std::size_t begin, particles;
    const WallAnchor* wall;  ///< [walls]
    std::size_t walls;
    std::int64_t step;
    double time_step, y_period;
    double range;                   ///< pairs and walls with separation below this are listed [m]
    const std::int32_t* old_place;  ///< [N] place of each particle in the lists before; null: the same

    [[nodiscard]] RECOAT_HD std::size_t slots() const { return particles * (1 + walls); }

    RECOAT_HD bool near_wall(std::size_t w, std::size_t i) const {
        return wall[w].active && wall_separation(wall[w], step, time_step, load(position, i)) < range;
    }
    RECOAT_HD std::int32_t before(std::int32_t i) const { return old_place ? old_place[i] : i; }
};

/// Writes one contact of a new list, with what the old one remembers of it.
struct ContactWriter {
    CloseListInput in;
    std::int32_t *first, *second;
    ContactView to;
    OldContacts awake, asleep;

    RECOAT_HD void pair(std::size_t k, std::int32_t i, std::int32_t j) const {
        // Where the partners change places, so does the sign of the first's displacement relative to the second.
        const std::int32_t a = in.before(i), b = in.before(j);
        const std::int32_t low = a < b ? a : b, high = a < b ? b : a;
        const OldContacts& old = of(low);
        write(k, i, j, old, old.pair(low, high), a < b ? 1 : -1);
    }
    RECOAT_HD void wall(std::size_t k, std::int32_t i, std::size_t w) const {
        const std::int32_t place = in.before(i);
        const OldContacts& old = of(place);
        write(k, i, -1 - static_cast<std::int32_t>(w), old, old.wall(place, w), 1);
    }

private:
    RECOAT_HD const OldContacts& of(std::int32_t place) const { return awake.has(place) ? awake : asleep; }
    RECOAT_HD void write(std::size_t k, std::int32_t i, std::int32_t j, const OldContacts& from, std::int32_t old,
                         double sign) const {
        first[k] = i;
        second[k] = j;
        to.slip_x[k] = old < 0 ? 0 : sign * from.slip_x[old];
        to.slip_y[k] = old < 0 ? 0 : sign * from.slip_y[old];
        to.slip_z[k] = old < 0 ? 0 : sign * from.slip_z[old];
        to.attraction[k] = old < 0 ? 0 : from.attraction[old];
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
            const std::size_t i = in.begin + slot;
            const Row p = load(in.position, i);
            for (std::int32_t e = begin[i]; e < begin[i + 1]; ++e)
                count += nearer(p, load(in.position, partner[e]), period, in.range);
        } else if (slot < in.slots()) {
            count = in.near_wall(slot / in.particles - 1, in.begin + slot % in.particles);
        }
        counts[slot] = count;
    });
}

/// Fills in ContactArrays::offsets of the list of `particles` particles from `begin` on from the contacts themselves.
template <class Space>
void list_offsets(Space& space, ContactArrays<Space>& c, std::size_t begin, std::size_t particles, std::size_t walls) {
    const std::int32_t *first = c.first.data(), *second = c.second.data();
    const std::size_t slots = particles * (1 + walls);
    const auto slot = [=] RECOAT_LAMBDA(std::size_t k) {
        const std::size_t wall = second[k] < 0 ? static_cast<std::size_t>(-second[k]) : 0;
        return static_cast<std::int32_t>(particles * wall + static_cast<std::size_t>(first[k]) - begin);
    };
    typename Space::template Array<std::int32_t> entries;
    space.group(c.size(), slots, slot, c.offsets, entries);
}

/// Fills in which contacts every particle of the list of the first `awake` particles has. `asked`: how many particles
/// may be asked for theirs; those that are not awake have none.
template <class Space>
void list_incidence(Space& space, ContactArrays<Space>& c, std::size_t awake, std::size_t asked) {
    const std::int32_t *first = c.first.data(), *second = c.second.data();
    const auto none = static_cast<std::int32_t>(awake);
    const auto bucket = [=] RECOAT_LAMBDA(std::size_t entry) {
        const std::int32_t i = entry % 2 ? second[entry / 2] : first[entry / 2];
        return i < 0 || i > none ? none : i;
    };
    c.incidence_begin.resize(asked + 1);
    space.group(2 * c.size(), awake, bucket, c.incidence_begin, c.incidence);
    c.incidence_begin.resize(asked + 1);
    std::int32_t* begin = c.incidence_begin.data();
    space.for_each(asked - awake, [=] RECOAT_LAMBDA(std::size_t k) { begin[awake + 1 + k] = begin[awake]; });
}

/// Fills in what the passes need of the list of the first `awake` particles: room for a step, who has which contacts.
/// `particles`: all of them.
template <class Space>
void complete_list(Space& space, ContactArrays<Space>& c, const ContactModel& model, std::size_t awake,
                   std::size_t particles) {
    const bool relative = model.rolling_form == RollingForm::relative;
    c.resize_scratch(model.hamaker > 0, relative);
    list_incidence(space, c, awake, relative ? particles : awake);
}

/// Lists the pairs of a range of particles, as firsts, that can touch or attract in the coming steps, and hands the
/// history over to them; energies that were counted are not carried over. `history` is that of the lists before, in
/// which particles had the places of `input.old_place`.
template <class Space>
void make_close_list(Space& space, const CloseListInput& in, const FarList<Space>& far,
                     const ContactHistory<Space>& history, ContactArrays<Space>& contacts) {
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
                               history.awake.view(),
                               history.asleep.view()};
    const std::int32_t *offsets = contacts.offsets.data(), *begin = far.begin.data(), *partner = far.second.data();
    const Period period(in.y_period);
    space.for_each(in.slots(), [=] RECOAT_LAMBDA(std::size_t slot) {
        auto k = static_cast<std::size_t>(offsets[slot]);
        if (slot < in.particles) {
            const std::size_t i = in.begin + slot;
            const Row p = load(in.position, i);
            for (std::int32_t e = begin[i]; e < begin[i + 1]; ++e)
                if (nearer(p, load(in.position, partner[e]), period, in.range))
                    writer.pair(k++, static_cast<std::int32_t>(i), partner[e]);
        } else if (offsets[slot + 1] > offsets[slot]) {
            writer.wall(k, static_cast<std::int32_t>(in.begin + slot % in.particles), slot / in.particles - 1);
        }
    });
}

}  // namespace recoat
