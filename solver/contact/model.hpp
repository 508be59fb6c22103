#pragma once

namespace recoat {

/// How the van der Waals attraction enters a step [docs/physics.md section 2.5].
enum class CohesionScheme {
    discrete_gradient,     ///< work-exact impulse over the path of the step (default)
    explicit_force,        ///< force at the separation of the step's start
    prediction_correction  ///< the paper's eq. 9, as read in docs/physics.md section 2.5
};

/// Angular velocity that rolling resistance opposes [paper eq. 3].
enum class RollingForm {
    own,      ///< the particle's own (the paper's form), applied by implicit projection
    relative  ///< that of the pair; equal and opposite torques, conserves angular momentum
};

/// Length that multiplies the rolling friction coefficient; the paper leaves it out.
enum class RollingLength { radius, reduced_radius, diameter };

/// Elastic modulus of walls: as that of the particles, or infinite.
enum class WallModulus { elastic, rigid };

/// Arm of the tangential force: to the common contact point (conserves angular momentum), or the radius.
enum class LeverArm { contact_point, radius };

/// Tangential dashpot: same coefficient as the normal one, or absent.
enum class TangentialDamping { as_normal, none };

/// Hamaker constant used out of contact: the original one, or the reduced one (common practice, wrong).
enum class NonContactHamaker { original, reduced };

/// Everything that the contact law needs, with the original (unscaled) material. SI units.
struct ContactModel {
    double density = 0;           ///< [kg/m3]
    double youngs_modulus = 0;    ///< Y^O [Pa]
    double poisson_ratio = 0;     ///< nu [-]
    double restitution = 1;       ///< e [-], of a binary normal impact without cohesion
    double sliding_friction = 0;  ///< mu_t [-]
    double rolling_friction = 0;  ///< mu_r [-], times the rolling length
    double stiffness_ratio = 1;   ///< Y^R/Y^O [-]

    double hamaker = 0;                    ///< A^O [J]; 0: no cohesion
    double minimum_separation = 1.65e-10;  ///< s_min [m]
    double cut_off = 1e-7;                 ///< s_max [m]

    CohesionScheme scheme = CohesionScheme::discrete_gradient;
    NonContactHamaker non_contact = NonContactHamaker::original;
    RollingForm rolling_form = RollingForm::own;
    RollingLength rolling_length = RollingLength::radius;
    WallModulus wall_modulus = WallModulus::elastic;
    LeverArm lever_arm = LeverArm::contact_point;
    TangentialDamping tangential_damping = TangentialDamping::as_normal;
    bool cap_dashpot = true;   ///< tangential spring plus dashpot is limited to mu_t |F|
    bool clip_normal = false;  ///< forbid a viscous force that makes the contact force attractive

    friend bool operator==(const ContactModel&, const ContactModel&) = default;
};

}  // namespace recoat
