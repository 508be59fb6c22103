#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "solver/contact/law.hpp"
#include "solver/contact/mindlin.hpp"
#include "tests/support/paper_model.hpp"
#include "tests/support/verification.hpp"

namespace recoat {
namespace {

using testing::paper_model;
using testing::paper_radius;

constexpr double friction = 0.3, slip_per_overlap = 0.3 * 1.7 / 1.4;
constexpr Mindlin mindlin{friction, slip_per_overlap, 1.0}, uncapped{friction, slip_per_overlap, 0.0};
constexpr double load = 1e-6, overlap = 2e-9, longest = slip_per_overlap * overlap;

Kinematics still(Vec3 normal = {0, 0, -1}) { return {normal, -overlap, 0, {}}; }
Kinematics sliding(Vec3 velocity) { return {{0, 0, -1}, -overlap, 0, velocity}; }

/// Force without dashpot; the displacement may be shortened.
Vec3 spring(Vec3& displacement) { return mindlin.force(displacement, load, overlap, 1 / overlap, 0.0, still()); }

double slope_at_zero(const ContactModel& model, bool wall, double contact_overlap) {
    const EqualSizes sizes = equal_sizes(model, paper_radius);
    const Coefficients& c = wall ? sizes.wall : sizes.pair;
    const double normal = c.hertz * contact_overlap * std::sqrt(contact_overlap);
    const Mindlin& law = contact_law<false>(model).mindlin;
    // The spring softens as 1 - x/4: two lengths take that away.
    const double unit = law.slip_per_overlap * contact_overlap;
    const auto stiffness = [&](double share) {
        Vec3 displacement = {share * unit, 0, 0};
        return -law.force(displacement, normal, contact_overlap, 1 / contact_overlap, 0.0, still()).x / (share * unit);
    };
    return 2 * stiffness(1e-5) - stiffness(2e-5);
}

// (3/2) mu F / d_max = 8 G* sqrt(R* d) for any friction and Poisson ratio [docs/physics.md section 1.5]: it ties E*,
// G* and d_max together.
TEST(Mindlin, StartsWithMindlinsStiffness) {
    for (const double poisson : {0.0, 0.2, 0.3, 0.49})
        for (const double mu : {0.05, 0.3, 1.0})
            for (const bool wall : {false, true}) {
                ContactModel model = paper_model(1, 0);
                model.poisson_ratio = poisson;
                model.sliding_friction = mu;
                const double d = 3e-10, shear = pair_moduli(model.youngs_modulus, poisson).shear;
                const double reduced_radius = wall ? paper_radius : 0.5 * paper_radius;
                const double expected = 8 * shear * std::sqrt(reduced_radius * d);
                testing::verify_relative("stiffness", slope_at_zero(model, wall, d), expected, 1e-10);
            }
}

TEST(Mindlin, FollowsTheCurveOfThePaper) {
    for (const double share : {0.1, 0.5, 0.9}) {
        Vec3 displacement = {0, share * longest, 0};
        const Vec3 force = spring(displacement);
        EXPECT_NEAR(-force.y, friction * load * (1 - std::pow(1 - share, 1.5)), 1e-14 * load);
        EXPECT_EQ(force.x, 0);
        EXPECT_DOUBLE_EQ(displacement.y, share * longest);
    }
}

// Loading and unloading run on one curve: a closed loop within the stick range costs nothing.
TEST(Mindlin, AClosedLoopDoesNoWork) {
    const int steps = 20000;
    const auto at = [&](int k) {
        const double t = 2 * std::numbers::pi * k / steps;
        return Vec3{0.4 * longest * std::sin(t), 0.3 * longest * (1 - std::cos(t)), 0};
    };
    double work = 0, along = 0;
    for (int k = 0; k < steps; ++k) {
        Vec3 middle = 0.5 * (at(k) + at(k + 1));
        const double done = dot(spring(middle), at(k + 1) - at(k));
        work += done;
        along += std::fabs(done);
    }
    EXPECT_GT(along, 0.1 * friction * load * longest);
    EXPECT_LT(std::fabs(work), 1e-6 * along);
}

TEST(Mindlin, EnergyIsTheIntegralOfTheSpring) {
    for (const double share : {0.2, 0.7, 1.0}) {
        const int steps = 4000;
        double work = 0;
        for (int k = 0; k < steps; ++k) {
            Vec3 displacement = {share * longest * (k + 0.5) / steps, 0, 0};
            work -= spring(displacement).x * share * longest / steps;
        }
        EXPECT_NEAR(mindlin.energy({share * longest, 0, 0}, load, overlap), work, 1e-6 * work);
    }
    EXPECT_EQ(mindlin.energy({}, 0, 0), 0);
    EXPECT_EQ(mindlin.energy({1e-9, 0, 0}, 0, 0), 0);
}

TEST(Mindlin, SlidingLimitsForceAndDisplacement) {
    Vec3 displacement = {3 * longest, 4 * longest, 0};
    const Vec3 force = mindlin.force(displacement, load, overlap, 1 / overlap, 1e-3, sliding({0.1, 0, 0}));
    // No dashpot while sliding, and the force lies along the displacement, not along the velocity.
    EXPECT_NEAR(norm(force), friction * load, 1e-14 * load);
    EXPECT_NEAR(force.x / force.y, 0.75, 1e-12);
    EXPECT_LT(force.x, 0);
    EXPECT_NEAR(norm(displacement), longest, 1e-14 * longest);
    EXPECT_NEAR(displacement.x / displacement.y, 0.75, 1e-12);
}

TEST(Mindlin, UnloadingShortensTheDisplacement) {
    Vec3 displacement = {0.9 * longest, 0, 0};
    const Vec3 force = mindlin.force(displacement, 0.3 * load, 0.5 * overlap, 2 / overlap, 0.0, still());
    EXPECT_NEAR(displacement.x, 0.5 * longest, 1e-14 * longest);
    EXPECT_NEAR(force.x, -friction * 0.3 * load, 1e-14 * load);
}

TEST(Mindlin, DashpotOpposesSlidingAndIsCapped) {
    const double dashpot = 1e-5;
    Vec3 displacement = {};
    const Vec3 slow = mindlin.force(displacement, load, overlap, 1 / overlap, dashpot, sliding({0, 1e-3, 0}));
    EXPECT_NEAR(slow.y, -dashpot * 1e-3, 1e-14 * load);
    const Vec3 fast = mindlin.force(displacement, load, overlap, 1 / overlap, dashpot, sliding({0, 1, 0}));
    EXPECT_NEAR(fast.y, -friction * load, 1e-14 * load);
    const Vec3 free = uncapped.force(displacement, load, overlap, 1 / overlap, dashpot, sliding({0, 1, 0}));
    EXPECT_NEAR(free.y, -dashpot, 1e-14 * dashpot);
}

TEST(Mindlin, WithoutLoadThereIsNoForceAndTheDisplacementStays) {
    Vec3 displacement = {1e-10, 0, 0};
    const Vec3 force = mindlin.force(displacement, 0.0, 0.0, 0.0, 0.0, sliding({0.1, 0, 0}));
    EXPECT_EQ(norm(force), 0);
    EXPECT_EQ(displacement, (Vec3{1e-10, 0, 0}));
}

TEST(Mindlin, HistoryTurnsWithTheContactAtItsLength) {
    Vec3 displacement = {0.3e-9, 0.4e-9, 0};
    const double length = norm(displacement);
    const double angle = 0.2;
    const Vec3 normal = {std::sin(angle), 0, -std::cos(angle)};
    const Vec3 turned = mindlin.advance(displacement, still(normal), 1e-7);
    EXPECT_NEAR(norm(turned), length, 1e-14 * length);
    EXPECT_NEAR(dot(turned, normal), 0, 1e-14 * length);
    EXPECT_GT(dot(turned, displacement), 0);
    EXPECT_EQ(mindlin.advance(Vec3{}, still(normal), 1e-7), (Vec3{}));
}

TEST(Mindlin, HistoryGrowsBySliding) {
    const Vec3 grown = mindlin.advance(Vec3{1e-10, 0, 0}, sliding({0, 0.02, 0}), 1e-8);
    EXPECT_NEAR(grown.x, 1e-10, 1e-24);
    EXPECT_NEAR(grown.y, 2e-10, 1e-24);
    const Vec3 kept = mindlin.advance(Vec3{1e-10, 0, 0}, sliding({0, 0.02, 0}), 0.0);
    EXPECT_NEAR(norm(kept - Vec3{1e-10, 0, 0}), 0, 1e-24);
}

}  // namespace
}  // namespace recoat
