#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "tests/analytic/oblique_impact.hpp"
#include "tests/support/reference.hpp"
#include "tests/support/verification.hpp"

namespace recoat {
namespace {

using testing::head_on_pair;
using testing::pair_rate;
using testing::pair_separation;
using testing::reference;
using testing::verify_relative;
namespace powder = testing::powder;

struct Leg {
    double rate, duration;
};

/// Rate at the end of the overlap and its duration, of a Bo 400 pair that first touches at `speed`; `steps` in the
/// contact. Both ends lie between steps.
Leg contact_leg(double ratio, double speed, double expected_duration, int steps) {
    const double time_step = expected_duration / steps;
    // A thousandth of a step of flight: the attraction out of contact does nothing to it.
    const double ahead = 1e-3 * speed * time_step;
    const auto engine = head_on_pair(powder::model(ratio, 400), time_step, ahead, speed).engine();
    ParticleTable now = engine->particles(), before;
    do {
        before = now;
        engine->advance(1);
        now = engine->particles();
    } while (pair_separation(now) < 0);
    const double share = -pair_separation(before) / (pair_separation(now) - pair_separation(before));
    return {pair_rate(before), engine->time() - (1 - share) * time_step - 1e-3 * time_step};
}

// docs/physics.md section 2.1: the contact of a cohesive pair, from first touch to last, is the same at every ratio but
// for the clock, r^(-2/5).
TEST(ScalingLaw, of_the_contact_is_exact) {
    for (const std::string speed : {"0.01", "0.05", "0.5"})
        for (const double ratio : {1.0, 0.1, 0.01, 0.001}) {
            const double duration = reference("contact." + speed + ".duration") * std::pow(ratio, -0.4);
            const Leg found = contact_leg(ratio, std::stod(speed), duration, 4000);
            const std::string where = speed + " m/s, r = " + std::to_string(ratio);
            verify_relative("speed at the end", found.rate, reference("contact." + speed + ".out"), 1e-3, where);
            verify_relative("duration", found.duration, duration, 1e-3, where);
        }
}

// Section 2.2: what the idea costs. The friction impulse of a sliding collision grows with its duration, by
// mu F_v t_c (r^(-2/5) - 1): 25 % of the blade's 50 mm/s at Bo 400 and r = 0.001.
TEST(ScalingLaw, lengthens_the_friction_of_a_collision_by_what_is_known) {
    for (const int bond : {5, 50, 400}) {
        const auto loss = [&](double ratio) {
            ContactModel model = powder::model(ratio, bond);
            model.rolling_friction = 0;
            // So fast along the wall that it slides all the time.
            return 1 -
                   testing::ObliqueImpact{model, powder::radius, 0.05, 2e-11 * std::pow(ratio, -0.4)}.run(1).tangential;
        };
        const double duration = reference("touch.wall." + std::to_string(bond) + ".duration");
        const double expected = 0.3 * 2 * bond * powder::gravity * duration * (std::pow(0.001, -0.4) - 1);
        verify_relative("speed lost more than at the original stiffness", loss(0.001) - loss(1), expected, 0.01,
                        std::to_string(bond));
    }
}

}  // namespace
}  // namespace recoat
