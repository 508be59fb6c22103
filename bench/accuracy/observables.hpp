#pragma once

#include "bench/accuracy/bodies.hpp"

namespace recoat {

/// Speed far away after an impact at `speed` from the cut-off [m/s]; 0 when the bodies stay together. `phase` in [0,
/// 1): share of a step by which the start is moved back.
double rebound_speed(const Bodies& bodies, double speed, double phase);

/// Speed below which the bodies stay together [m/s], to 1e-4 of itself; looked for from `guess`, or from the escape
/// speed when that is 0. Infinite when they stay together at 100 times the guess, 0 when they part at a hundredth.
double capture_speed(const Bodies& bodies, double guess, double phase);

/// Way of a sphere that slides at `speed` until it rests, in diameters; NaN when it does not come to rest within
/// `longest` [s].
double stop_distance(const Bodies& bodies, double speed, double longest);

/// What an impact on the wall at the normal speed `speed` and `slope` times that along it does to the motion along it,
/// in units of the normal speed: change of the velocity.
double oblique_change(const Bodies& bodies, double speed, double slope, double phase);

/// Load that takes a sphere off its wall, over the largest attraction; the load grows evenly to twice that in
/// `duration` [s]. 2: it never came off.
double pull_off_load(const Bodies& bodies, double duration);

}  // namespace recoat
