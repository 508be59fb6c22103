#include "solver/cli/calibration.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <fstream>
#include <limits>

#include <unistd.h>

#include "common/error.hpp"
#include "solver/output/output_size.hpp"

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

/// Of the calling thread: it calculates, or waits actively for those that help it.
double thread_seconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Steps that take about `seconds`.
std::int64_t steps_of(Engine& engine, double seconds) {
    for (std::int64_t steps = 8;; steps *= 2) {
        const Clock::time_point start = Clock::now();
        engine.advance(steps);
        const double taken = std::chrono::duration<double>(Clock::now() - start).count();
        if (taken >= 0.25 * seconds)
            return std::max<std::int64_t>(1, std::llround(static_cast<double>(steps) * seconds / taken));
    }
}

/// Steps per second, the best of several measurements; adds the share of the processor.
double best_rate(Engine& engine, Calibration& result) {
    constexpr int measurements = 6;
    constexpr double seconds_of_one = 0.07;
    const std::int64_t steps = steps_of(engine, seconds_of_one);
    double best = 0, seconds = 0;
    const double processor = thread_seconds();
    for (int i = 0; i < measurements; ++i) {
        const Clock::time_point start = Clock::now();
        engine.advance(steps);
        const double taken = std::chrono::duration<double>(Clock::now() - start).count();
        best = std::max(best, static_cast<double>(steps) / taken);
        seconds += taken;
    }
    result.processor_share = std::min(1.0, (thread_seconds() - processor) / seconds);
    return best;
}

}  // namespace

Calibration calibrate(const Scene& scene, std::int64_t particles, const Resources& resources,
                      const EngineFactory& factory) {
    const int edge = std::clamp(static_cast<int>(std::cbrt(static_cast<double>(particles))), 2, 32);
    const double before = resident_bytes();
    const ParticleTable block = cubic_block(scene.diameter, edge);
    const auto engine = factory.make(open_setup(scene, resources), block, {});
    const auto count = static_cast<double>(block.size());
    Calibration result;
    result.particles = block.size();
    try {
        engine->advance(2);
        result.bytes_per_particle = std::max(0.0, resident_bytes() - before) / count;
        result.particle_steps_per_second = best_rate(*engine, result) * count;
    } catch (const SimulationFault&) {
        // Contacts that no step can follow; what is wrong with the scene is said by its notes.
    }
    result.checkpoint_bytes_per_particle = engine_bytes(engine->save()) / count;
    if (resources.backend != Backend::cpu) result.processor_share = 1;  // a device calculates, the thread waits
    return result;
}

}  // namespace recoat
