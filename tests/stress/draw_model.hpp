#pragma once

#include <string>

#include "solver/scene/scene.hpp"
#include "tests/stress/draw.hpp"

namespace recoat::stress {

/// Material, contact, attraction, gravity and time step of a scene.
struct ModelDraw {
    std::string text;       ///< their keys
    double diameter = 0;    ///< d_p [m]
    double time_step = 0;   ///< [s]
    double step_share = 0;  ///< of the stability limit at `speed`
    double speed = 0;       ///< at which things are meant to move [m/s]
    double smallest = 0;    ///< radius of the smallest particles [m]
    double cut_off = 0;     ///< of the attraction; 0 without [m]
    double separation = 0;  ///< s_min [m]
    bool gravity = false;
};

/// From the usual to far beyond it: Bo 0 to 1e4, e 0.01 to 1, friction 0 to 2, stiffness ratio 1e-5 to 1, steps from
/// 1e-3 to 2 of the stability limit of the smallest particles.
ModelDraw draw_model(Draw& draw, bool needs_gravity);

}  // namespace recoat::stress
