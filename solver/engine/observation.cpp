#include "solver/engine/observation.hpp"

#include <algorithm>

#include "solver/engine/close_list.hpp"
#include "solver/engine/energy.hpp"
#include "solver/engine/partners.hpp"
#include "solver/engine/scene_types.hpp"
#include "solver/engine/step_passes.hpp"

namespace recoat {

namespace {

std::int64_t identity(const Snapshot& s, std::int32_t place) {
    return place < 0 ? place : s.particles.id[static_cast<std::size_t>(place)];
}

/// Calls f(contact, meeting, coefficients) for every contact of a list, in order.
template <class Sizes, class Function>
void visit_meetings(Snapshot& s, const Contacts& c, const EngineSetup& setup, const Sizes& sizes, const Function& f) {
    const ParticleView p = s.particles.view();
    visit_partners(setup, sizes, s.walls.now(), c, [&](const auto& partner, std::size_t from, std::size_t count) {
        for (std::size_t k = from; k < from + count; ++k)
            f(k, partner.meet(p, c.first[k], c.second[k]), partner.coefficients(p, c.first[k], c.second[k]));
    });
}

/// The passes of a scene on the host, with a control of their own.
template <class Sizes, bool cohesive, bool relative_rolling>
struct HostStep {
    Snapshot& s;
    StepPasses<Sizes, cohesive, relative_rolling> passes;
    OpenMP space;
    StepControl control;
    std::vector<WallAnchor> anchors;

    HostStep(Snapshot& snapshot, const EngineSetup& setup, const Sizes& sizes)
        : s(snapshot),
          passes(setup, sizes, smallest_radius(setup, snapshot.particles)),
          space(setup.resources.threads),
          anchors(snapshot.walls.anchors()) {
        control.step = s.step;
        control.awake = s.awake;
    }

    [[nodiscard]] StepMemory memory() { return {&control, anchors.data()}; }
};

template <class Function>
auto with_host_step(Snapshot& s, const EngineSetup& setup, const Function& f) {
    return with_scene_types(setup, s.particles, [&](const auto& sizes, auto cohesive, auto relative) {
        HostStep<std::decay_t<decltype(sizes)>, cohesive, relative> step(s, setup, sizes);
        return f(step, cohesive);
    });
}

std::vector<ContactState> ordered(std::vector<ContactState> contacts) {
    for (ContactState& c : contacts) {
        if (c.second < 0 || c.first < c.second) continue;
        std::swap(c.first, c.second);
        c.normal = -c.normal;
        c.tangential_force = -c.tangential_force;
    }
    std::sort(contacts.begin(), contacts.end(), [](const ContactState& a, const ContactState& b) {
        return a.first != b.first ? a.first < b.first : a.second < b.second;
    });
    return contacts;
}

/// Counts sleepers, and their contacts, among the awake.
void wake(Snapshot& s) {
    Contacts both;
    both.pairs = s.contacts.pairs + s.dormant.pairs;
    both.wall_begin.push_back(both.pairs);
    const auto append = [&](Contacts& from, std::size_t begin, std::size_t end) {
        from.each_saved(both, [&](const auto& part, auto& whole) {
            whole.insert(whole.end(), part.begin() + static_cast<std::ptrdiff_t>(begin),
                         part.begin() + static_cast<std::ptrdiff_t>(end));
        });
    };
    append(s.contacts, 0, s.contacts.pairs);
    append(s.dormant, 0, s.dormant.pairs);
    for (std::size_t w = 0; w + 1 < s.contacts.wall_begin.size(); ++w) {
        append(s.contacts, s.contacts.wall_begin[w], s.contacts.wall_begin[w + 1]);
        append(s.dormant, s.dormant.wall_begin[w], s.dormant.wall_begin[w + 1]);
        both.wall_begin.push_back(both.size());
    }
    s.contacts = std::move(both);
    s.dormant = {};
    s.awake = s.particles.size();
    s.lost_rolling.resize(s.awake, 0.0);
}

}  // namespace

void complete(Snapshot& s, const EngineSetup& setup) {
    OpenMP space(setup.resources.threads);
    const std::size_t n = s.particles.size();
    if (s.awake < n) wake(s);
    list_offsets(space, s.contacts, 0, n, s.walls.now().size());
    complete_list(space, s.contacts, setup.model, n, n);
}

std::vector<ContactState> contacts_of(Snapshot s, const EngineSetup& setup) {
    complete(s, setup);
    return with_host_step(s, setup, [&](auto& step, auto cohesive) {
        Snapshot& now = step.s;
        step.space.run(step.passes.contacts(now, step.memory(), 0));
        std::vector<ContactState> found;
        visit_meetings(
            now, now.contacts, setup, step.passes.sizes(),
            [&](std::size_t k, const Meeting& meeting, const Coefficients&) {
                if (meeting.separation > (cohesive ? setup.model.cut_off : 0.0)) return;
                const Vec3 force = now.contacts.force[k].force();
                const double along = dot(force, meeting.normal);
                found.push_back({identity(now, now.contacts.first[k]), identity(now, now.contacts.second[k]),
                                 meeting.normal, meeting.separation, -along, force - along * meeting.normal});
            });
        return ordered(std::move(found));
    });
}

Totals next_bookings(Snapshot s, const EngineSetup& setup) {
    complete(s, setup);
    return with_host_step(s, setup, [&](auto& step, auto) {
        clear_counters(step.space, step.s.contacts, step.s.lost_rolling);
        step.space.run(step.passes.contacts(step.s, step.memory(), setup.time_step));
        Totals booked;
        booked.add(step.space, step.s.contacts, step.s.lost_rolling);
        return booked;
    });
}

EnergyLedger ledger_of(const Snapshot& snapshot, const EngineSetup& setup) {
    auto& s = const_cast<Snapshot&>(snapshot);
    EnergyLedger ledger = with_host_step(s, setup, [&](auto& step, auto) {
        const auto& passes = step.passes;
        EnergyLedger stored = particle_energies(s.particles, passes.sizes(), setup.gravity);
        for (const Contacts* contacts : {&s.contacts, &s.dormant})
            visit_meetings(s, *contacts, setup, passes.sizes(),
                           [&](std::size_t k, const Meeting& m, const Coefficients& c) {
                               add_contact_energy(stored, passes.law(), passes.attraction(), m.separation,
                                                  contacts->attraction[k], contacts->slip(k), c);
                           });
        return stored;
    });
    OpenMP space(setup.resources.threads);
    Totals totals = s.totals;
    totals.add(space, s.contacts, s.lost_rolling);
    totals.add(next_bookings(s, setup), 0.5);
    ledger.dissipated_normal = totals.lost_normal;
    // What friction took includes what its springs still hold.
    ledger.dissipated_tangential = totals.lost_tangential - ledger.elastic_tangential;
    ledger.dissipated_rolling = totals.lost_rolling;
    ledger.wall_work = totals.wall_work;
    ledger.removed_with_walls = totals.removed_with_walls;
    return ledger;
}

}  // namespace recoat
