#include "solver/cli/calibration.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <limits>

#include <unistd.h>

namespace recoat {
namespace {

using Clock = std::chrono::steady_clock;

double resident_bytes() {
    std::ifstream stream("/proc/self/statm");
    double total = 0, resident = 0;
    stream >> total >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

/// `edge`^3 spheres that overlap their neighbours by 1e-5 d_p.
ParticleTable cubic_block(double diameter, int edge) {
    const double spacing = diameter * (1 - 1e-5);
    ParticleTable table;
    for (int z = 0; z < edge; ++z) {
        for (int y = 0; y < edge; ++y) {
            for (int x = 0; x < edge; ++x) {
                table.position.push_back({(x + 0.5) * spacing, (y + 0.5) * spacing, (z + 0.5) * spacing});
            }
        }
    }
    table.velocity.resize(table.position.size());
    table.angular_velocity.resize(table.position.size());
    table.radius.assign(table.position.size(), 0.5 * diameter);
    return table;
}

EngineSetup open_setup(const Scene& scene, const Resources& resources) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    EngineSetup setup = engine_setup(scene, resources);
    setup.gravity = {};
    setup.y_period = 0;
    setup.domain_lower = {-infinity, -infinity, -infinity};
    setup.domain_upper = {infinity, infinity, infinity};
    return setup;
}

}  // namespace

Calibration calibrate(const Scene& scene, std::int64_t particles, const Resources& resources,
                      const EngineFactory& factory) {
    const int edge = std::clamp(static_cast<int>(std::cbrt(static_cast<double>(particles))), 2, 32);
    const double before = resident_bytes();
    const ParticleTable block = cubic_block(scene.diameter, edge);
    const auto engine = factory.make(open_setup(scene, resources), block, {});
    engine->advance(2);
    Calibration result;
    result.particles = block.size();
    result.bytes_per_particle = std::max(0.0, resident_bytes() - before) / static_cast<double>(block.size());
    const Clock::time_point start = Clock::now();
    std::int64_t steps = 0;
    double seconds = 0;
    for (std::int64_t chunk = 8; seconds < 0.4; chunk *= 2) {
        engine->advance(chunk);
        steps += chunk;
        seconds = std::chrono::duration<double>(Clock::now() - start).count();
    }
    result.particle_steps_per_second = static_cast<double>(steps) * static_cast<double>(block.size()) / seconds;
    return result;
}

}  // namespace recoat
