#pragma once

#include <vector>

#include "solver/engine/engine.hpp"

namespace recoat {

/// Where everything was when the blade of a spread stage stopped.
struct BladeStop {
    double rear = 0;        ///< x of the blade's rear face [m]
    std::vector<double> x;  ///< [N] of the centres, in order of identity [m]; empty: no blade has stopped yet
};

/// End of the layer that is as the blade left it [m]. The heap in front leans on the gap under the blade, and without
/// cohesion some of it flows back through it once the blade stands still. The layer ends at the largest x, the rear
/// face at most, over which no sphere has come back since: neither one of the heap nor one that it pushed. Ways of less
/// than a twentieth of `diameter` (d_p [m]) do not count.
double layer_end(const BladeStop& stop, const ParticleTable& now, double diameter);

}  // namespace recoat
