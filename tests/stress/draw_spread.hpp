#pragma once

#include "tests/stress/case.hpp"
#include "tests/stress/draw.hpp"

namespace recoat::stress {

/// Fill, heap and spread of 1 to 60 particles in a box of some diameters; the blade up to 100 times faster than the
/// time step is made for.
Case draw_spread_case(Draw& draw);

}  // namespace recoat::stress
