#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "tests/support/reference.hpp"
#include "tests/support/small_scene.hpp"

namespace recoat {
namespace {

using testing::head_on_pair;
using testing::over_plane;
using testing::pair_rate;
using testing::pair_separation;
using testing::reference;
namespace powder = testing::powder;

/// A pair, or a sphere and a wall, that meet under attraction; seen by separation and its rate only.
struct Approach {
    ContactModel model;
    bool wall = false;
    double time_step = 2e-8;

    /// Speed far away after an impact from the speed `speed` at the cut-off; 0: captured. `phase`: of the first step.
    ///
    /// The flight is followed until `horizon`; the little work of the attraction beyond is then subtracted.
    [[nodiscard]] double rebound(double speed, double phase, double horizon) const {
        const double start = model.cut_off + phase * speed * time_step;
        const auto scene =
            wall ? over_plane(model, time_step, start, {0, 0, -speed}) : head_on_pair(model, time_step, start, speed);
        const auto engine = scene.engine();
        bool turned = false;
        while (engine->time() < 3 * model.cut_off / speed + 1e-2) {
            engine->advance(4);
            const ParticleTable now = engine->particles();
            const double separation = wall ? now.position[0].z - now.radius[0] : pair_separation(now);
            const double rate = wall ? now.velocity[0].z : pair_rate(now);
            if (turned && rate < 0) return 0;
            turned = rate > 0;
            if (turned && separation >= horizon) return far_speed(rate, separation);
        }
        ADD_FAILURE() << "neither captured nor gone";
        return 0;
    }

    /// Approach speed below which the pair stays together, to 1e-4 of `guess`; within `width` of it.
    [[nodiscard]] double capture(double guess, double phase, double width) const {
        const double horizon = 20 * model.minimum_separation;
        double lower = (1 - width) * guess, upper = (1 + width) * guess;
        EXPECT_EQ(rebound(lower, phase, horizon), 0);
        EXPECT_GT(rebound(upper, phase, horizon), 0);
        while (upper - lower > 2e-4 * guess) {
            const double middle = 0.5 * (lower + upper);
            (rebound(middle, phase, horizon) > 0 ? upper : lower) = middle;
        }
        return 0.5 * (lower + upper);
    }

private:
    /// What is left of the speed `rate` at `separation` in the range of 1/s^2 [docs/physics.md section 2.4].
    [[nodiscard]] double far_speed(double rate, double separation) const {
        const double outside =
            model.non_contact == NonContactHamaker::original ? 1 : attraction_scaling(model.stiffness_ratio);
        // Force over reduced mass: the same for a pair, A R/12 over m/2, and for a wall, A R/6 over m.
        const double strength = outside * model.hamaker * powder::radius / 6 / powder::mass;
        const double left = strength * std::max(0.0, 1 / separation - 1 / model.cut_off);
        return std::sqrt(std::max(0.0, rate * rate - 2 * left));
    }
};

/// Relative errors over the phases.
struct Errors {
    double mean = 0, worst = 0;
};

template <class Measure>
Errors errors(int phases, double expected, const Measure& measure) {
    Errors found;
    for (int k = 0; k < phases; ++k) {
        const double error = measure((k + 0.5) / phases) / expected - 1;
        found.mean += error / phases;
        found.worst = std::max(found.worst, std::fabs(error));
    }
    return found;
}

/// Of the capture velocity of the Bond number, looked for within `width` of `guess` times the reference.
Errors capture_errors(const Approach& approach, int bond, int phases, double width, double guess = 1) {
    const double expected =
        reference(std::string("capture.") + (approach.wall ? "wall." : "pair.") + std::to_string(bond));
    return errors(phases, expected, [&](double phase) { return approach.capture(guess * expected, phase, width); });
}

class Capture : public ::testing::TestWithParam<int> {};

// docs/physics.md section 2.6: capture velocities within 0.2 % at 2e-8 s.
TEST_P(Capture, velocity_is_exact_at_the_step_of_the_paper) {
    for (const bool wall : {false, true}) {
        const Approach approach{powder::model(0.001, GetParam()), wall};
        const Errors found = capture_errors(approach, GetParam(), 8, 0.02);
        EXPECT_LT(found.worst, 0.002) << (wall ? "wall" : "pair") << ", mean error " << found.mean;
        RecordProperty(wall ? "wall" : "pair", std::to_string(1e6 * found.mean) + "e-6");
        RecordProperty(wall ? "wall_worst" : "pair_worst", std::to_string(1e6 * found.worst) + "e-6");
    }
}

// And within 1 % at 1e-7 s.
TEST_P(Capture, velocity_holds_at_five_times_the_step) {
    for (const bool wall : {false, true}) {
        const Approach approach{powder::model(0.001, GetParam()), wall, 1e-7};
        const Errors found = capture_errors(approach, GetParam(), 16, 0.05);
        EXPECT_LT(found.worst, 0.01) << (wall ? "wall" : "pair") << ", mean error " << found.mean;
        RecordProperty(wall ? "wall" : "pair", std::to_string(1e6 * found.mean) + "e-6");
        RecordProperty(wall ? "wall_worst" : "pair_worst", std::to_string(1e6 * found.worst) + "e-6");
    }
}

// Section 2.1: the scaling law is exact, so that the ratio only changes the error of the step.
TEST_P(Capture, velocity_does_not_depend_on_the_stiffness) {
    for (const double ratio : {0.1, 0.01}) {
        const Approach approach{powder::model(ratio, GetParam()), false};
        EXPECT_LT(std::fabs(capture_errors(approach, GetParam(), 8, 0.05).mean), ratio == 0.1 ? 0.008 : 0.004) << ratio;
    }
}

// Section 2.6: rebound from 1.05, 1.5, 2 and 5 times the capture velocity, and from 0.05 m/s.
TEST_P(Capture, rebound_is_that_of_the_reference) {
    const std::pair<std::string, double> cases[] = {{"1.05", 0.02}, {"1.5", 0.005}, {"2", 0.003}, {"5", 0.0025}};
    for (const bool wall : {false, true}) {
        const std::string kind = wall ? "wall." : "pair.", bond = std::to_string(GetParam());
        const Approach approach{powder::model(0.001, GetParam()), wall};
        const double capture = reference("capture." + kind + bond);
        const auto check = [&](const std::string& name, double speed, double tolerance) {
            const double expected = reference("rebound." + kind + bond + "." + name);
            const Errors found = errors(
                16, expected, [&](double phase) { return approach.rebound(speed, phase, powder::model().cut_off); });
            EXPECT_LT(std::fabs(found.mean), tolerance) << kind << name;
            EXPECT_LT(found.worst, 1.5 * tolerance) << kind << name;
        };
        for (const auto& [name, tolerance] : cases) check(name, std::stod(name) * capture, tolerance);
        check("fast", 0.05, 0.002);
    }
}

INSTANTIATE_TEST_SUITE_P(BondNumber, Capture, ::testing::Values(5, 50, 400),
                         [](const auto& bond) { return "bond_" + std::to_string(bond.param); });

// Section 2.6: the other schemes have the errors of the table; the reduced Hamaker constant out of contact is wrong.
TEST(CaptureSchemes, have_the_errors_of_the_table) {
    struct Case {
        int bond;
        double reduced_everywhere, explicit_spread, correction_spread;
    };
    for (const Case& c :
         {Case{5, -0.64, 0.0034, 0.0031}, Case{50, -0.50, 0.0095, 0.0059}, Case{400, -0.31, 0.016, 0.016}}) {
        Approach approach{powder::model(0.001, c.bond)};
        approach.model.scheme = CohesionScheme::explicit_force;
        const Errors explicit_force = capture_errors(approach, c.bond, 32, 0.1);
        EXPECT_NEAR(explicit_force.mean, 0, 0.003) << c.bond;
        EXPECT_LT(explicit_force.worst, 1.4 * c.explicit_spread) << c.bond;

        approach.model.scheme = CohesionScheme::prediction_correction;
        const Errors correction = capture_errors(approach, c.bond, 32, 0.1);
        EXPECT_NEAR(correction.mean, 0, 0.004) << c.bond;
        EXPECT_LT(correction.worst, 1.4 * c.correction_spread) << c.bond;

        approach.model.scheme = CohesionScheme::explicit_force;
        approach.model.non_contact = NonContactHamaker::reduced;
        const Errors reduced = capture_errors(approach, c.bond, 8, 0.3, 1 + c.reduced_everywhere);
        EXPECT_NEAR(reduced.mean, c.reduced_everywhere, 0.02) << c.bond;
    }
}

// Section 2.6: release from rest at 0.3 nm.
TEST(Release, from_rest_within_the_range_falls_together) {
    const auto model = powder::model(0.001, 400);
    const auto engine = head_on_pair(model, 2e-8, 3e-10, 0).engine();
    double separation = 3e-10, rate = 0;
    while (separation > 0) {
        engine->advance(1);
        separation = pair_separation(engine->particles());
        rate = pair_rate(engine->particles());
        ASSERT_LT(engine->step(), 100);
    }
    // Touch lies within the last step; there the attraction has dropped to the reduced one.
    EXPECT_NEAR(engine->time() + separation / -rate, reference("release.time"), 0.01 * reference("release.time"));
    EXPECT_NEAR(-rate, reference("release.speed"), 0.01 * reference("release.speed"));
}

}  // namespace
}  // namespace recoat
