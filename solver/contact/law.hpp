#pragma once

#include "solver/contact/attraction.hpp"
#include "solver/contact/cube_root.hpp"
#include "solver/contact/hertz.hpp"
#include "solver/contact/mindlin.hpp"
#include "solver/contact/rolling.hpp"

namespace recoat {

/// What one contact does to its first partner, and what that costs.
struct ContactResult {
    Vec3 force;               ///< repulsion and friction on the first partner [N]
    Vec3 tangential;          ///< friction alone [N]
    double friction_load;     ///< F^M: normal force that friction and rolling see [N]
    double normal_power;      ///< dissipated by the normal dashpot [W]
    double tangential_power;  ///< taken by friction from the motion [W]
};

/// The contact law without the attraction itself: Hertz, Mindlin-Deresiewicz, and the force that friction sees under
/// stiffness scaling [paper eq. 4, 5, 8; docs/physics.md sections 1 and 2.2].
template <bool cohesive>
struct ContactLaw {
    Hertz hertz;
    Mindlin mindlin;
    Rolling rolling;
    double frictional_range;  ///< a pair keeps its tangential displacement up to this separation [m]: s_min, or 0

    /// `attraction`: mean attraction that the pair felt in the previous step [N]. `displacement` is that of half a step
    /// before on entry and of half a step after on return, so that the sliding velocity of this instant counts on both
    /// sides: the sum is the trapezoidal rule, and a contact that began somewhere in the last step has slid for half.
    RECOAT_HD ContactResult operator()(const Kinematics& k, const Coefficients& c, double attraction, double time_step,
                                       Vec3& displacement) const {
        const double overlap = k.separation < 0 ? -k.separation : 0;
        const double root = std::sqrt(overlap);
        const double quarter = std::sqrt(root);
        const double elastic = hertz.elastic(overlap, root, c);
        const double viscous = hertz.viscous(elastic, quarter, k.closing_rate, c);

        const Load load = friction_load(elastic, overlap, quarter, attraction, k.separation, c);
        const double kept = k.separation <= frictional_range ? 1 : 0;
        displacement = kept * mindlin.advance(displacement, k, 0.5 * time_step);
        const Vec3 tangential =
            mindlin.force(displacement, load.force, load.overlap, c.tangential_damping * load.quarter, k);
        displacement += (0.5 * kept * time_step) * k.sliding_velocity;

        ContactResult result;
        result.tangential = tangential;
        result.force = tangential - (elastic + viscous) * k.normal;
        result.friction_load = load.force;
        result.normal_power = -viscous * k.closing_rate;
        result.tangential_power = -dot(tangential, k.sliding_velocity);
        return result;
    }

    struct Load {
        double force;    ///< F^M [N]
        double overlap;  ///< Hertz-equivalent overlap of F^M [m]
        double quarter;  ///< its fourth root
    };

    /// F^M = max(0, F_cn^R - F_v + F_v^O), and the overlap at which Hertz gives it [docs/physics.md 2.2 (a), (c)].
    RECOAT_HD Load friction_load(double elastic, double overlap, double quarter, double attraction, double separation,
                                 const Coefficients& c) const {
        if constexpr (cohesive) {
            const double sum = elastic - attraction + c.attraction_friction;
            const double force = separation <= frictional_range && sum > 0 ? sum : 0;
            const double root = cube_root(force / c.hertz);
            return {force, root * root, std::sqrt(root)};
        } else {
            return {elastic, overlap, quarter};
        }
    }
};

template <bool cohesive>
ContactLaw<cohesive> contact_law(const ContactModel& model) {
    const double nu = model.poisson_ratio;
    return {Hertz{model.clip_normal ? 1.0 : 0.0},
            Mindlin{model.sliding_friction, model.sliding_friction * (2 - nu) / (2 - 2 * nu),
                    model.cap_dashpot ? 1.0 : 0.0},
            Rolling{model.rolling_friction}, cohesive ? model.minimum_separation : 0.0};
}

}  // namespace recoat
