#pragma once

#include <algorithm>
#include <utility>
#include <variant>

#include "solver/contact/impulse.hpp"
#include "solver/contact/model.hpp"

namespace recoat {

/// The scheme of the attraction, chosen once per scene.
template <class Real>
using ImpulseChoiceOf = std::variant<FixedPointImpulse<2, Real>, SecantImpulse<3, Real>, BracketedImpulse<Real>,
                                     ExplicitImpulse<Real>, PredictionCorrectionImpulse<Real>>;
using ImpulseChoice = ImpulseChoiceOf<double>;

/// How often the pairs of a step are solved again.
template <class Real>
int corrections_of(const ImpulseChoiceOf<Real>& choice) {
    return std::visit([](const auto& impulse) { return impulse.half_step_positions ? corrections_of_impulses : 0; },
                      choice);
}

/// The same scheme with numbers of another type.
template <class Real>
ImpulseChoiceOf<Real> cast(const ImpulseChoice& choice) {
    const auto parts = [](const auto& impulse) {
        return std::pair{AttractionOf<Real>{static_cast<Real>(impulse.attraction.minimum_separation),
                                            static_cast<Real>(impulse.attraction.cut_off)},
                         static_cast<Real>(impulse.time_step)};
    };
    const auto [attraction, time_step] = std::visit(parts, choice);
    switch (choice.index()) {
        case 0:
            return FixedPointImpulse<2, Real>{attraction, time_step};
        case 1:
            return SecantImpulse<3, Real>{attraction, time_step};
        case 2:
            return BracketedImpulse<Real>{attraction, time_step};
        case 3:
            return ExplicitImpulse<Real>{attraction, time_step};
        default:
            return PredictionCorrectionImpulse<Real>{attraction, time_step};
    }
}

/// Contraction of the fixed point per iteration, dt^2 F_o / (2 m* s_min), at its largest [docs/physics.md section 2.5].
inline double impulse_contraction(const Coefficients& c, double minimum_separation, double time_step) {
    return 0.5 * time_step * time_step * c.inverse_mass * c.attraction_gap / minimum_separation;
}

/// Contractions up to which 2 fixed-point iterations and 3 secant steps leave less than 1e-4 of the force; beyond, the
/// bracketed secant is taken, which always converges but does not run as a vector loop.
inline constexpr double small_contraction = 0.04;
inline constexpr double large_contraction = 0.35;

/// `smallest`: radius of the smallest particle [m].
template <class Sizes>
ImpulseChoice choose_impulse(const ContactModel& model, double time_step, const Sizes& sizes, double smallest) {
    const Attraction attraction{model.minimum_separation, model.cut_off};
    switch (model.scheme) {
        case CohesionScheme::explicit_force:
            return ExplicitImpulse<>{attraction, time_step};
        case CohesionScheme::prediction_correction:
            return PredictionCorrectionImpulse<>{attraction, time_step};
        case CohesionScheme::discrete_gradient:
            break;
    }
    // The contraction grows as 1/R^2: the smallest particles decide.
    const double contraction =
        std::max(impulse_contraction(sizes.of_pair(smallest, smallest), model.minimum_separation, time_step),
                 impulse_contraction(sizes.of_wall(smallest), model.minimum_separation, time_step));
    if (contraction < small_contraction) return FixedPointImpulse<2>{attraction, time_step};
    if (contraction < large_contraction) return SecantImpulse<3>{attraction, time_step};
    return BracketedImpulse<>{attraction, time_step};
}

}  // namespace recoat
