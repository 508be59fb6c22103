#pragma once

#include <type_traits>

#include "solver/contact/coefficients.hpp"
#include "solver/engine/snapshot.hpp"

namespace recoat {

/// Picks the types that a scene needs, once: calls f(sizes, is it cohesive, does rolling resistance act on the relative
/// spin), the latter two as std::bool_constant.
template <class Function>
auto with_scene_types(const EngineSetup& setup, const Particles& particles, const Function& f) {
    const auto with_sizes = [&](const auto& sizes) {
        const bool relative = setup.model.rolling_form == RollingForm::relative;
        if (setup.model.hamaker > 0)
            return relative ? f(sizes, std::true_type{}, std::true_type{})
                            : f(sizes, std::true_type{}, std::false_type{});
        return relative ? f(sizes, std::false_type{}, std::true_type{})
                        : f(sizes, std::false_type{}, std::false_type{});
    };
    if (particles.size() > 0 && !equal_radii(particles)) return with_sizes(any_sizes(setup.model));
    const double radius = particles.size() > 0 ? particles.position.front().w : 0.5 * setup.diameter;
    return with_sizes(equal_sizes(setup.model, radius));
}

/// Radius of the smallest particle; half a diameter d_p where there is none [m].
inline double smallest_radius(const EngineSetup& setup, const Particles& particles) {
    return particles.size() > 0 ? smallest_radius(particles) : 0.5 * setup.diameter;
}

}  // namespace recoat
