#include "solver/output/packing_density.hpp"

#include <algorithm>
#include <numbers>

namespace recoat {

double bed_packing_density(const ParticleTable& particles, double area) {
    if (particles.size() == 0) return 0;
    double top = -1e300, bottom = 1e300;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        top = std::max(top, particles.position[i].z + particles.radius[i]);
        bottom = std::min(bottom, particles.position[i].z - particles.radius[i]);
    }
    double volume = 0;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const double r = particles.radius[i];
        if (particles.position[i].z <= 0.9 * top) volume += 4.0 / 3.0 * std::numbers::pi * r * r * r;
    }
    return volume / (area * (0.9 * top - bottom));
}

}  // namespace recoat
