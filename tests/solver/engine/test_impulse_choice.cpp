#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "solver/engine/impulse_choice.hpp"
#include "tests/support/paper_model.hpp"

namespace recoat {
namespace {

using testing::paper_model;
using testing::paper_radius;

/// Largest error of the energy of an isolated pair over random steps, in units of its well.
double largest_error(const ImpulseChoice& choice, const Coefficients& c, double dt) {
    const Attraction attraction{1.65e-10, 1e-7};
    std::mt19937_64 random(9);
    std::uniform_real_distribution<double> unit(0, 1);
    double worst = 0;
    for (int k = 0; k < 20000; ++k) {
        const double size = std::pow(10, -12 + 5 * unit(random)), speed = std::pow(10, -6 + 5 * unit(random));
        const double s0 = random() % 2 ? size : -size, u = random() % 2 ? speed : -speed;
        const double force = std::visit([&](const auto& impulse) { return impulse(s0, u, c); }, choice);
        const double after = u - force * dt * c.inverse_mass, s1 = s0 + 0.5 * dt * (u + after);
        const double gained = -0.5 * force * dt * (u + after);
        worst = std::max(worst, std::fabs(gained - attraction.well(s1, c) + attraction.well(s0, c)));
    }
    return worst / attraction.well(0.0, c);
}

// Whatever solver the step and the strength call for, it must be good enough.
TEST(ImpulseChoice, KeepsTheEnergyAtAnyStepAndStrength) {
    for (const double bond : {1.0, 5.0, 50.0, 200.0, 400.0})
        for (const double dt : {2e-9, 2e-8, 5e-8, 1e-7, 1.8e-7, 2e-7, 3e-7}) {
            const ContactModel model = paper_model(0.001, bond);
            const EqualSizes sizes = equal_sizes(model, paper_radius);
            const ImpulseChoice choice = choose_impulse(model, dt, sizes, paper_radius);
            for (const Coefficients& c : {sizes.pair, sizes.wall})
                EXPECT_LT(largest_error(choice, c, dt), 1e-4) << "Bo " << bond << ", dt " << dt;
        }
}

TEST(ImpulseChoice, TakesTheSchemeAskedFor) {
    ContactModel model = paper_model(0.001, 50);
    const EqualSizes sizes = equal_sizes(model, paper_radius);
    model.scheme = CohesionScheme::explicit_force;
    EXPECT_TRUE(std::holds_alternative<ExplicitImpulse<>>(choose_impulse(model, 2e-8, sizes, paper_radius)));
    model.scheme = CohesionScheme::prediction_correction;
    EXPECT_TRUE(
        std::holds_alternative<PredictionCorrectionImpulse<>>(choose_impulse(model, 2e-8, sizes, paper_radius)));
}

// The contraction grows as the square of the step and of the inverse radius: the smallest particles decide.
TEST(ImpulseChoice, SmallParticlesNeedTheStrongerSolver) {
    const ContactModel model = paper_model(0.001, 400);
    const AnySizes sizes = any_sizes(model);
    const ImpulseChoice large = choose_impulse(model, 2e-8, sizes, paper_radius);
    const ImpulseChoice small = choose_impulse(model, 2e-8, sizes, paper_radius / 10);
    EXPECT_FALSE(std::holds_alternative<BracketedImpulse<>>(large));
    EXPECT_TRUE(std::holds_alternative<BracketedImpulse<>>(small));
    const Coefficients pair = sizes.of_pair(paper_radius / 10, paper_radius / 10);
    EXPECT_LT(largest_error(small, pair, 2e-8), 1e-4);
    EXPECT_NEAR(impulse_contraction(pair, model.minimum_separation, 2e-8) /
                    impulse_contraction(sizes.of_pair(paper_radius, paper_radius), model.minimum_separation, 1e-8),
                400, 1e-9);
}

}  // namespace
}  // namespace recoat
