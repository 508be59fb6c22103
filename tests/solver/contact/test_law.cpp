#include <cmath>

#include <gtest/gtest.h>

#include "solver/contact/law.hpp"
#include "tests/support/paper_model.hpp"

namespace recoat {
namespace {

using testing::paper_model;
using testing::paper_radius;

constexpr double weight = 2.844339083698e-9;  // m g of the paper's particle [N]

struct Scaled {
    ContactModel model;
    ContactLaw<true> law;
    Coefficients wall;
};

Scaled scaled(double ratio, double bond) {
    const ContactModel model = paper_model(ratio, bond);
    return {model, contact_law<true>(model), equal_sizes(model, paper_radius).wall};
}

/// Overlap at which Hertz gives `force`.
double overlap_of(double force, const Coefficients& c) { return std::pow(force / c.hertz, 2.0 / 3.0); }

FrictionLoad<double> load_at(const Scaled& s, double separation, double attraction) {
    const double overlap = std::max(-separation, 0.0), root = std::sqrt(overlap);
    return s.law.friction_load(
        FrictionLoad<double>{s.law.hertz.elastic(overlap, root, s.wall), overlap, std::sqrt(root), 1 / overlap},
        attraction, separation, s.wall);
}

// At rest the scaled contact carries F_v^R + load; friction must see F_v^O + load, as at full stiffness
// [docs/physics.md section 2.2].
TEST(ContactLaw, FrictionSeesTheOriginalForceAtRest) {
    for (const double ratio : {1.0, 0.1, 0.001})
        for (const double bond : {5.0, 50.0, 400.0}) {
            const Scaled s = scaled(ratio, bond);
            const double original = 2 * bond * weight;  // a wall pulls twice as strongly as a pair
            for (const double external : {0.0, weight, -0.5 * s.wall.attraction_contact}) {
                const double overlap = overlap_of(s.wall.attraction_contact + external, s.wall);
                const double expected = original + external;
                EXPECT_NEAR(load_at(s, -overlap, s.wall.attraction_contact).force, expected, 1e-9 * expected);
            }
        }
}

// Its Hertz-equivalent overlap is the one at which Hertz would give it [docs/physics.md section 2.2 (c)].
TEST(ContactLaw, EquivalentOverlapGivesTheFrictionLoad) {
    const Scaled s = scaled(0.001, 50);
    for (const double overlap : {0.0, 1e-12, 1e-10, 5e-9}) {
        const auto load = load_at(s, -overlap, s.wall.attraction_contact);
        EXPECT_NEAR(s.law.hertz.elastic(load.overlap, std::sqrt(load.overlap), s.wall), load.force, 1e-10 * load.force);
        EXPECT_NEAR(std::pow(load.overlap, 0.25), load.quarter, 1e-10 * load.quarter);
        // However small the overlap, the stiffness of the friction spring stays bounded.
        EXPECT_GT(load.overlap, 1e-10);
    }
}

// While a pair comes closer in the gap, the attraction applied is F_o: nothing is left for friction [2.2 (b)].
TEST(ContactLaw, NoFrictionInTheGap) {
    const Scaled s = scaled(0.001, 50);
    EXPECT_NEAR(load_at(s, 1e-10, s.wall.attraction_gap).force, 0, 1e-15 * s.wall.attraction_gap);
    // A contact that hovers was held by less than F_o in the step before, and still feels the difference.
    EXPECT_NEAR(load_at(s, 1e-10, s.wall.attraction_contact).force,
                s.wall.attraction_friction - s.wall.attraction_contact, 1e-9 * s.wall.attraction_gap);
    EXPECT_EQ(load_at(s, 1.001 * s.model.minimum_separation, 0).force, 0);
    EXPECT_EQ(load_at(s, 1e-10, 2 * s.wall.attraction_gap).force, 0);
}

TEST(ContactLaw, DisplacementIsKeptUpToTheMinimumSeparation) {
    const Scaled s = scaled(0.001, 50);
    Vec3 near = {1e-11, 0, 0}, far = near;
    s.law(Kinematics{{0, 0, -1}, 1.6e-10, 0, {}}, s.wall, s.wall.attraction_gap, 2e-8, near);
    s.law(Kinematics{{0, 0, -1}, 1.7e-10, 0, {}}, s.wall, s.wall.attraction_gap, 2e-8, far);
    EXPECT_DOUBLE_EQ(near.x, 1e-11);
    EXPECT_EQ(norm(Vec3{0, near.y, near.z}), 0);
    EXPECT_EQ(far, (Vec3{}));
}

TEST(ContactLaw, WithoutCohesionFrictionSeesHertzAndEndsWithTheContact) {
    const ContactModel model = paper_model(0.001, 0);
    const ContactLaw<false> law = contact_law<false>(model);
    const Coefficients c = equal_sizes(model, paper_radius).pair;
    Vec3 slip = {1e-12, 0, 0};
    const ContactResult touching = law(Kinematics{{0, 0, -1}, -1e-9, 0, {}}, c, 0.0, 2e-8, slip);
    EXPECT_NEAR(touching.friction_load, c.hertz * std::pow(1e-9, 1.5), 1e-12 * touching.friction_load);
    EXPECT_EQ(slip, (Vec3{1e-12, 0, 0}));
    const ContactResult apart = law(Kinematics{{0, 0, -1}, 1e-12, 0, {}}, c, 0.0, 2e-8, slip);
    EXPECT_EQ(apart.force, (Vec3{}));
    EXPECT_EQ(slip, (Vec3{}));
}

// Repulsion drives the first partner away from the second; the powers are those that its parts take from the motion.
TEST(ContactLaw, ForceAndPowersBelongTogether) {
    const ContactModel model = paper_model(0.001, 0);
    const ContactLaw<false> law = contact_law<false>(model);
    const Coefficients c = equal_sizes(model, paper_radius).pair;
    const Vec3 normal = {0, 0.6, -0.8}, slide = {0.01, 0.008, 0.006};
    const double closing = -0.03;
    Vec3 slip = {};
    const ContactResult result = law(Kinematics{normal, -1e-8, closing, slide}, c, 0.0, 2e-8, slip);
    EXPECT_LT(dot(result.force, normal), 0);
    EXPECT_NEAR(dot(result.tangential, normal), 0, 1e-14 * norm(result.tangential));
    const double elastic = c.hertz * std::pow(1e-8, 1.5);
    const double viscous = -dot(result.force, normal) - elastic;
    EXPECT_NEAR(result.normal_power, -viscous * closing, 1e-12 * viscous * 0.03);
    EXPECT_GT(result.normal_power, 0);
    EXPECT_NEAR(result.tangential_power, -dot(result.tangential, slide), 1e-25);
    EXPECT_GT(result.tangential_power, 0);
}

}  // namespace
}  // namespace recoat
