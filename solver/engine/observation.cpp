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

/// Calls f(contact, meeting, coefficients) for every listed contact, in order.
template <class Sizes, class Function>
void visit_meetings(Snapshot& s, const EngineSetup& setup, const Sizes& sizes, const Function& f) {
    const ParticleView p = s.particles.view();
    const Contacts& c = s.contacts;
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

}  // namespace

void complete(Snapshot& s, const EngineSetup& setup) {
    OpenMP space(setup.resources.threads);
    complete_list(space, s.contacts, setup.model, s.particles.size(), s.walls.now().size());
}

std::vector<ContactState> contacts_of(Snapshot s, const EngineSetup& setup) {
    complete(s, setup);
    return with_host_step(s, setup, [&](auto& step, auto cohesive) {
        Snapshot& now = step.s;
        step.space.run(step.passes.contacts(now, step.memory(), 0));
        std::vector<ContactState> found;
        visit_meetings(
            now, setup, step.passes.sizes(), [&](std::size_t k, const Meeting& meeting, const Coefficients&) {
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
        visit_meetings(s, setup, passes.sizes(), [&](std::size_t k, const Meeting& m, const Coefficients& c) {
            add_contact_energy(stored, passes.law(), passes.attraction(), m.separation, s.contacts.attraction[k],
                               s.contacts.slip(k), c);
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
