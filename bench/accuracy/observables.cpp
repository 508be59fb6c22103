#include "bench/accuracy/observables.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

namespace recoat {
namespace {

constexpr std::int64_t steps_per_look = 4;

double horizon(const Bodies& bodies) { return 20 * bodies.model().minimum_separation; }

/// Where braking goes on as it did over the last part, from the speed `before` to rest [m].
double rest_of_the_way(double before, double after, double time) {
    const double brake = (before - after) / time;
    return brake > 0 ? 0.5 * before * before / brake : 0;
}

}  // namespace

double rebound_speed(const Bodies& bodies, double speed, double phase) {
    const double cut_off = bodies.model().cut_off;
    const auto engine = bodies.approaching(cut_off + phase * speed * bodies.time_step(), speed);
    const double longest = 3 * cut_off / speed + 1e-2;
    bool turned = false;
    while (engine->time() < longest) {
        engine->advance(steps_per_look);
        const ParticleTable now = engine->particles();
        const double separation = bodies.separation(now), rate = bodies.rate(now);
        if (turned && rate < 0) return 0;
        turned = turned || rate > 0;
        if (turned && separation >= horizon(bodies)) return bodies.far_speed(rate, separation);
    }
    return 0;
}

double capture_speed(const Bodies& bodies, double guess, double phase) {
    const double start = guess > 0 ? guess : bodies.escape_speed();
    double lower = 0.97 * start, upper = 1.03 * start;
    while (rebound_speed(bodies, lower, phase) > 0) {
        upper = lower;
        lower *= 0.8;
        if (lower < 0.01 * start) return 0;
    }
    while (rebound_speed(bodies, upper, phase) == 0) {
        lower = upper;
        upper *= 1.25;
        if (upper > 100 * start) return std::numeric_limits<double>::infinity();
    }
    while (upper - lower > 2e-4 * lower) {
        const double middle = 0.5 * (lower + upper);
        (rebound_speed(bodies, middle, phase) > 0 ? upper : lower) = middle;
    }
    return 0.5 * (lower + upper);
}

double stop_distance(const Bodies& bodies, double speed, double longest) {
    const auto engine = bodies.sliding(speed);
    const std::int64_t part = std::max<std::int64_t>(1, std::llround(longest / bodies.time_step() / 2000));
    while (engine->time() < longest) {
        engine->advance(part);
        const ParticleTable now = engine->particles();
        const double before = now.velocity[0].x;
        if (before > 2e-3 * speed) continue;
        engine->advance(part);
        const double time = static_cast<double>(part) * bodies.time_step();
        const double left = rest_of_the_way(before, engine->particles().velocity[0].x, time);
        return (now.position[0].x + left) / bodies.diameter();
    }
    return std::numeric_limits<double>::quiet_NaN();
}

double oblique_change(const Bodies& bodies, double speed, double slope, double phase) {
    const auto engine = bodies.glancing((3 + phase) * speed * bodies.time_step(), speed, slope * speed);
    for (;;) {
        engine->advance(steps_per_look);
        const ParticleTable now = engine->particles();
        if (!(bodies.separation(now) > 0 && bodies.rate(now) > 0)) continue;
        // The last force is still in the velocity.
        engine->advance(steps_per_look);
        return engine->particles().velocity[0].x / speed - slope;
    }
}

double pull_off_load(const Bodies& bodies, double duration) {
    const double time_step = bodies.time_step();
    const std::int64_t part = std::max<std::int64_t>(1, std::llround(duration / time_step / 5000));
    const double largest = bodies.attraction() / bodies.weight();  // in weights
    auto engine = bodies.hanging();
    for (;;) {
        const double load = 2 * engine->time() / duration;
        if (load > 2) return 2;
        engine = bodies.pulled(*engine, load * largest * bodies.gravity());
        engine->advance(part);
        if (bodies.separation(engine->particles()) > horizon(bodies)) return load;
    }
}

}  // namespace recoat
