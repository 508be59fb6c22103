#include "solver/engine/fault.hpp"
#include "solver/engine/observation.hpp"
#include "solver/engine/partners.hpp"
#include "solver/engine/scene_types.hpp"
#include "solver/engine/step_passes.hpp"

namespace recoat {

namespace {

/// The contact that stopped the step is the deepest one.
template <class Sizes>
SimulationFault deepest(Snapshot& s, const EngineSetup& setup, const Sizes& sizes) {
    std::int64_t first = -1, second = -1;
    double overlap = 0;
    const ParticleView p = s.particles.view();
    const auto name = [&](std::int32_t place) {
        return place < 0 ? std::int64_t{place} : s.particles.id[static_cast<std::size_t>(place)];
    };
    visit_partners(setup, sizes, s.walls.now(), s.contacts,
                   [&](const auto& partner, std::size_t from, std::size_t count) {
                       for (std::size_t k = from; k < from + count; ++k) {
                           const std::int32_t i = s.contacts.first[k], j = s.contacts.second[k];
                           const double depth = -partner.meet(p, i, j).separation;
                           if (!(depth > overlap)) continue;
                           overlap = depth;
                           first = name(i);
                           second = name(j);
                       }
                   });
    return overlap_fault(s, setup, first, second, overlap);
}

/// The particle that stopped the step is one whose next speed is beyond the limit, or else the fastest.
template <class Pass>
std::int64_t fastest(const Snapshot& s, const Pass& pass, double limit) {
    std::int64_t found = -1;
    double highest = -1;
    for (std::size_t i = 0; i < s.particles.size(); ++i) {
        const double speed = pass.next_speed(i);
        if (!(speed < limit)) return s.particles.id[i];
        if (speed > highest) {
            highest = speed;
            found = s.particles.id[i];
        }
    }
    return found;
}

template <class Sizes, bool cohesive, bool relative_rolling>
SimulationFault too_fast(Snapshot& s, const EngineSetup& setup, const Sizes& sizes) {
    const StepPasses<Sizes, cohesive, relative_rolling> passes(setup, sizes, smallest_radius(setup, s.particles));
    OpenMP space(1);
    StepControl control;
    control.step = s.step;
    control.awake = s.awake;
    const std::vector<WallAnchor> anchors = s.walls.anchors();
    const StepMemory memory{&control, anchors.data()};
    space.run(passes.contacts(s, memory, setup.time_step));
    const auto forces = passes.forces(s, memory);
    std::int64_t culprit = fastest(s, forces.pass, passes.speed_limit());
    if constexpr (cohesive) {
        space.run(forces);
        if (std::isfinite(control.peak[static_cast<std::size_t>(StepStage::forces)]))
            passes.attract(
                s, memory, [&](const auto& loop) { space.run(loop); },
                [&](const auto& motion) { culprit = fastest(s, motion.pass, passes.speed_limit()); });
    }
    return speed_fault(s, setup, culprit, passes.speed_limit());
}

}  // namespace

SimulationFault fault_of(Snapshot s, const EngineSetup& setup, Halt halt) {
    complete(s, setup);
    return with_scene_types(setup, s.particles, [&](const auto& sizes, auto cohesive, auto relative) {
        if (halt == Halt::deep) return deepest(s, setup, sizes);
        return too_fast<std::decay_t<decltype(sizes)>, cohesive, relative>(s, setup, sizes);
    });
}

}  // namespace recoat
