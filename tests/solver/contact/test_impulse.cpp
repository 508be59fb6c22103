#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "solver/contact/impulse.hpp"
#include "tests/support/paper_model.hpp"

namespace recoat {
namespace {

using testing::paper_model;
using testing::paper_radius;

constexpr Attraction attraction{1.65e-10, 1e-7};

struct Case {
    double separation, rate;  // [m], [m/s]
};

/// Pairs on their way in and out, at rest and deep in contact, within one step of the range.
std::vector<Case> cases(unsigned seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<Case> made;
    for (int k = 0; k < 3000; ++k) {
        const double size = std::pow(10, -12 + 5 * unit(random)), rate = std::pow(10, -6 + 5 * unit(random));
        made.push_back({random() % 2 ? size : -size, random() % 2 ? rate : -rate});
    }
    for (const double s : {-1e-9, 0.0, 1e-10, 1e-9}) made.push_back({s, 0.0});
    return made;
}

/// How far the energy of an isolated pair is from exact after the impulse `force` dt, in units of the well at contact.
double energy_error(double s0, double u, double force, double dt, const Coefficients& c) {
    const double after = u - force * dt * c.inverse_mass;
    const double s1 = s0 + 0.5 * dt * (u + after);
    // (m*/2)(u+^2 - u*^2) as a product, which does not cancel.
    const double gained = -0.5 * force * dt * (u + after);
    const double released = attraction.well(s1, c) - attraction.well(s0, c);
    return std::fabs(gained - released) / attraction.well(0.0, c);
}

// (m*/2)(u+^2 - u*^2) = G(s1) - G(s0) [docs/physics.md section 2.5], for slow steps across the jump of the force at
// contact too.
TEST(Impulse, FixedPointKeepsTheEnergyOfAPair) {
    const double dt = 2e-8;
    for (const double bond : {5.0, 50.0, 400.0}) {
        const EqualSizes sizes = equal_sizes(paper_model(0.001, bond), paper_radius);
        const FixedPointImpulse<3> impulse{attraction, dt};
        for (const Coefficients& c : {sizes.pair, sizes.wall})
            for (const Case& k : cases(1)) {
                const double force = impulse(k.separation, k.rate, c);
                ASSERT_LT(energy_error(k.separation, k.rate, force, dt, c), 1e-7)
                    << k.separation << " " << k.rate << " Bo " << bond;
            }
    }
}

TEST(Impulse, BracketedSecantKeepsTheEnergyOfAPairAtLargeSteps) {
    for (const double dt : {2e-8, 1e-7, 2e-7})
        for (const double bond : {5.0, 50.0, 400.0}) {
            const Coefficients c = equal_sizes(paper_model(0.001, bond), paper_radius).pair;
            const BracketedImpulse<> impulse{attraction, dt};
            for (const Case& k : cases(2)) {
                const double force = impulse(k.separation, k.rate, c);
                ASSERT_LT(energy_error(k.separation, k.rate, force, dt, c), 1e-12)
                    << k.separation << " " << k.rate << " Bo " << bond << " dt " << dt;
            }
        }
}

TEST(Impulse, BothSolversSolveTheSameEquation) {
    const Coefficients c = equal_sizes(paper_model(0.001, 400), paper_radius).pair;
    const FixedPointImpulse<3> three{attraction, 2e-8};
    const BracketedImpulse<> bracketed{attraction, 2e-8};
    const double b = 0.5 * 4e-16 * c.inverse_mass;
    for (const Case& k : cases(3)) {
        const double force = bracketed(k.separation, k.rate, c);
        const double end = k.separation + k.rate * 2e-8 - b * force;
        ASSERT_NEAR(attraction.mean(k.separation, end, c), force, 1e-9 * c.attraction_gap)
            << k.separation << " " << k.rate;
        ASSERT_NEAR(three(k.separation, k.rate, c), force, 1e-6 * c.attraction_gap) << k.separation << " " << k.rate;
    }
}

// At rest within the range a particle must begin to move, and deep in contact the force is the constant one.
TEST(Impulse, HasNoDeadZones) {
    const Coefficients c = equal_sizes(paper_model(0.001, 50), paper_radius).pair;
    const BracketedImpulse<> bracketed{attraction, 2e-8};
    const FixedPointImpulse<3> fixed{attraction, 2e-8};
    EXPECT_NEAR(fixed(5e-11, 0.0, c), c.attraction_gap, 1e-12 * c.attraction_gap);
    EXPECT_NEAR(bracketed(5e-11, 0.0, c), c.attraction_gap, 1e-12 * c.attraction_gap);
    EXPECT_NEAR(fixed(-1e-8, 0.01, c), c.attraction_contact, 1e-12 * c.attraction_contact);
    EXPECT_NEAR(bracketed(-1e-8, 0.01, c), c.attraction_contact, 1e-12 * c.attraction_contact);
    EXPECT_EQ(fixed(2e-7, 0.0, c), 0);
    EXPECT_EQ(bracketed(2e-7, 0.0, c), 0);
}

TEST(Impulse, ExplicitTakesTheForceOfTheStart) {
    const Coefficients c = equal_sizes(paper_model(0.001, 50), paper_radius).pair;
    const ExplicitImpulse<> impulse{attraction, 2e-8};
    for (const Case& k : cases(4)) ASSERT_EQ(impulse(k.separation, k.rate, c), attraction.force(k.separation, c));
}

// The work is that over the predicted travel, out of contact only; a pair that cannot leave the well turns round.
TEST(Impulse, PredictionCorrectionWorksOverThePredictedTravel) {
    const double dt = 2e-8;
    const Coefficients c = equal_sizes(paper_model(0.001, 50), paper_radius).pair;
    const PredictionCorrectionImpulse<> impulse{attraction, dt};
    int reflected = 0;
    for (const Case& k : cases(5)) {
        const double force = impulse(k.separation, k.rate, c);
        if (k.separation < 0) {
            ASSERT_EQ(force, c.attraction_contact);
            continue;
        }
        const double after = k.rate - force * dt * c.inverse_mass;
        const double end = std::max(k.separation + k.rate * dt, 0.0);
        const double work = attraction.well(end, c) - attraction.well(k.separation, c);
        const double square = k.rate * k.rate + 2 * work * c.inverse_mass;
        reflected += square < 0;
        const double expected = square > 0 ? std::copysign(std::sqrt(square), k.rate) : -k.rate;
        const double kick = std::fabs(force) * dt * c.inverse_mass;
        ASSERT_NEAR(after, k.rate == 0 ? 0 : expected, 1e-11 * (kick + std::fabs(k.rate)))
            << k.separation << " " << k.rate;
    }
    EXPECT_GT(reflected, 50);
}

}  // namespace
}  // namespace recoat
