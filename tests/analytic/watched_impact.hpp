#pragma once

#include <algorithm>
#include <vector>

#include "solver/engine/engine.hpp"

namespace recoat::testing {

/// What is seen of one impact.
struct WatchedImpact {
    double overlap = 0;   ///< greatest [m]
    double force = 0;     ///< greatest repulsion [N]
    double duration = 0;  ///< of the overlap [s]
    double rate = 0;      ///< of the separation afterwards [m/s]
};

/// Height of the top of the parabola through three equidistant samples.
inline double top_of_parabola(double before, double top, double after) {
    const double slope = 0.5 * (after - before), bend = before - 2 * top + after;
    return top - 0.5 * slope * slope / bend;
}

/// Watches an impact without attraction step by step: `separation` of a table of particles, which closes at `speed`.
/// Both ends of the contact lie between samples, where the spheres fly freely; the top is that of a parabola.
template <class Separation>
WatchedImpact watch_impact(Engine& engine, double time_step, double speed, const Separation& separation,
                           int most_steps = 10000) {
    std::vector<double> overlaps = {-separation(engine.particles())}, forces = {0};
    bool touched = false;
    for (int step = 0; step < most_steps; ++step) {
        engine.advance(1);
        overlaps.push_back(-separation(engine.particles()));
        const auto contacts = engine.contacts();
        forces.push_back(contacts.empty() ? 0 : contacts.front().normal_force);
        touched = touched || overlaps.back() > 0;
        if (touched && overlaps.back() < 0 && overlaps[overlaps.size() - 2] < 0) break;
    }
    const auto first = std::find_if(overlaps.begin(), overlaps.end(), [](double d) { return d > 0; });
    const auto past = std::find_if(first, overlaps.end(), [](double d) { return d <= 0; });
    const auto top = std::max_element(first, past);
    const auto at = [&](const std::vector<double>& values) {
        const auto k = static_cast<std::size_t>(top - overlaps.begin());
        return top_of_parabola(values.at(k - 1), values.at(k), values.at(k + 1));
    };
    const double rate = (past[0] - past[1]) / time_step;
    const double sampled = static_cast<double>(past - first + 1) * time_step;
    return {at(overlaps), at(forces), sampled + first[-1] / speed + past[0] / rate, rate};
}

}  // namespace recoat::testing
