#include <cmath>

#include <gtest/gtest.h>

#include "solver/contact/hertz.hpp"
#include "tests/support/paper_model.hpp"

namespace recoat {
namespace {

using testing::paper_model;
using testing::paper_radius;

constexpr Hertz free_hertz{0.0}, clipped_hertz{1.0};

double elastic(double overlap, const Coefficients& c) { return free_hertz.elastic(overlap, std::sqrt(overlap), c); }

TEST(Hertz, EnergyIsTheIntegralOfTheForce) {
    const Coefficients c = equal_sizes(paper_model(0.001, 0), paper_radius).pair;
    for (const double overlap : {1e-12, 1e-10, 1e-8, 1e-6}) {
        // With d = overlap x^2 the integrand is a polynomial of degree 4, and Simpson's rule converges at once.
        const int intervals = 200;
        double sum = 0;
        for (int k = 0; k <= intervals; ++k) {
            const double x = static_cast<double>(k) / intervals;
            const double weight = k == 0 || k == intervals ? 1 : (k % 2 ? 4 : 2);
            sum += weight * elastic(overlap * x * x, c) * 2 * overlap * x;
        }
        const double integral = sum / (3 * intervals);
        EXPECT_NEAR(free_hertz.energy(overlap, c), integral, 1e-8 * integral);
    }
}

// Elastic impacts of Chung & Ooi's first two tests: energy and force at greatest overlap [docs/physics.md 5.1].
TEST(Hertz, GreatestOverlapAndForceOfElasticImpacts) {
    struct Impact {
        bool wall;
        double radius, modulus, poisson, density, speed, overlap, force;
    };
    const Impact impacts[] = {
        {false, 0.01, 4.8e10, 0.2, 2800, 20, 2.7411270209e-4, 1.0696888984e4},
        {false, 0.01, 2e10, 0.25, 2500, 20, 3.6830402555e-4, 7.1082412799e3},
        {true, 0.1, 7e10, 0.3, 2699, 0.2, 4.9717175242e-5, 1.1369858311e4},
        {true, 0.1, 4e10, 0.35, 1800, 0.2, 5.2123288318e-5, 7.2326810260e3},
    };
    for (const Impact& impact : impacts) {
        ContactModel model;
        model.density = impact.density;
        model.youngs_modulus = impact.modulus;
        model.poisson_ratio = impact.poisson;
        model.wall_modulus = WallModulus::rigid;
        const EqualSizes sizes = equal_sizes(model, impact.radius);
        const Coefficients& c = impact.wall ? sizes.wall : sizes.pair;
        const double energy = 0.5 / c.inverse_mass * impact.speed * impact.speed;
        EXPECT_NEAR(free_hertz.energy(impact.overlap, c) / energy, 1, 1e-9);
        EXPECT_NEAR(elastic(impact.overlap, c) / impact.force, 1, 1e-9);
    }
}

// The damping of eq. 4 as printed: 2 sqrt(5/6) beta sqrt(S_n m*) with S_n = 2 E* sqrt(R* d).
TEST(Hertz, DashpotIsThatOfThePaper) {
    const ContactModel model = paper_model(0.001, 0);
    const Coefficients c = equal_sizes(model, paper_radius).pair;
    const double modulus = pair_moduli(1.1e8, 0.3).normal, overlap = 3e-9, rate = -0.02;
    const double stiffness = 2 * modulus * std::sqrt(0.5 * paper_radius * overlap);
    const double mass = 0.5 * sphere_mass(paper_radius, model.density);
    const double dashpot = 2 * std::sqrt(5.0 / 6.0) * 0.279997993335 * std::sqrt(stiffness * mass);
    const double quarter = std::pow(overlap, 0.25);
    // Approach adds to the repulsion, departure takes from it.
    EXPECT_NEAR(free_hertz.viscous(0.0, quarter, rate, c), -dashpot * rate, 1e-11 * dashpot * 0.02);
    EXPECT_NEAR(free_hertz.viscous(0.0, quarter, -rate, c), dashpot * rate, 1e-11 * dashpot * 0.02);
}

TEST(Hertz, ClippingForbidsAnAttractiveSum) {
    const Coefficients c = equal_sizes(paper_model(0.001, 0), paper_radius).pair;
    const double overlap = 1e-11, quarter = std::pow(overlap, 0.25), repulsion = elastic(overlap, c);
    const double departing = 0.05;
    EXPECT_LT(repulsion + free_hertz.viscous(repulsion, quarter, departing, c), 0);
    EXPECT_EQ(repulsion + clipped_hertz.viscous(repulsion, quarter, departing, c), 0);
    EXPECT_EQ(clipped_hertz.viscous(repulsion, quarter, -departing, c),
              free_hertz.viscous(repulsion, quarter, -departing, c));
}

}  // namespace
}  // namespace recoat
