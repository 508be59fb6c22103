#include "solver/engine/fault.hpp"

#include <fmt/format.h>

#include "solver/engine/limits.hpp"

namespace recoat {

namespace {

std::string moment(const Snapshot& snapshot, const EngineSetup& setup) {
    return fmt::format("step {} (t = {:.6g} s)", snapshot.step, static_cast<double>(snapshot.step) * setup.time_step);
}

std::string partner_name(const Snapshot& snapshot, std::int64_t partner) {
    if (partner >= 0) return fmt::format("particle {}", partner);
    return fmt::format("wall '{}'", snapshot.walls.now()[static_cast<std::size_t>(-1 - partner)].name);
}

}  // namespace

SimulationFault overlap_fault(const Snapshot& snapshot, const EngineSetup& setup, std::int64_t first,
                              std::int64_t second, double overlap) {
    return SimulationFault(fmt::format(
        "{}: particle {} overlaps {} by {:.4g} m, more than {:g} of the smallest radius; the time step is too large, "
        "the start too dense, or a wall too fast: reduce time_step, or move the particles apart",
        moment(snapshot, setup), first, partner_name(snapshot, second), overlap, limits::overlap));
}

SimulationFault speed_fault(const Snapshot& snapshot, const EngineSetup& setup, std::int64_t particle, double limit) {
    return SimulationFault(fmt::format(
        "{}: particle {} would be faster than {:.4g} m/s, {:g} of the smallest radius per step, or its velocity is not "
        "a number; reduce time_step, or check the velocities given",
        moment(snapshot, setup), particle, limit, limits::travel_per_step));
}

void require_inside(const Particles& particles, const EngineSetup& setup, std::int64_t step) {
    const DomainCheck domain(setup);
    for (std::size_t k = 0; k < particles.size(); ++k) {
        const Vec3 x = particles.position[k].xyz();
        if (domain.inside(x)) continue;
        throw SimulationFault(
            fmt::format("step {}: particle {} at ({:.6g}, {:.6g}, {:.6g}) m has left the domain; add a wall there, or "
                        "enlarge the domain",
                        step, particles.id[k], x.x, x.y, x.z));
    }
}

}  // namespace recoat
