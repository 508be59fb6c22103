#pragma once

#include <string>
#include <vector>

#include "tests/stress/draw.hpp"
#include "tests/stress/draw_model.hpp"

namespace recoat::stress {

/// Particles of a scene and what is special about them.
struct ParticleDraw {
    struct Sphere {
        Vec3 position, velocity, spin;
        double radius = 0;
    };
    std::vector<Sphere> spheres;
    std::string character;
    Vec3 size;  ///< of the box that they are in, from the origin [m]

    [[nodiscard]] std::string table() const;
};

/// None, one or some spheres: apart, overlapping, touching to the bit, in one place, on edges; slow or hot.
ParticleDraw draw_particles(Draw& draw, const ModelDraw& model);

}  // namespace recoat::stress
