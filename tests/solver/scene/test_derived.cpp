#include <cmath>

#include <gtest/gtest.h>

#include "solver/scene/derived.hpp"
#include "tests/support/scene_text.hpp"
#include "tests/support/verification.hpp"

namespace recoat {
namespace {

using testing::scene_of;
using testing::spread_text;

DerivedNumbers numbers_at(const std::string& bond, const std::vector<std::string>& more = {}) {
    std::vector<std::string> settings = {"cohesion.bond_number=" + bond};
    settings.insert(settings.end(), more.begin(), more.end());
    return derived_numbers(scene_of(spread_text, settings));
}

// Values printed in docs/physics.md section 1.1.
TEST(Derived, ParticleOfThePaper) {
    const DerivedNumbers n = numbers_at("1");
    EXPECT_NEAR(n.mass, 2.899428219876e-10, 1e-22);
    EXPECT_NEAR(n.inertia, 7.248570549689e-20, 1e-32);
    EXPECT_NEAR(n.weight, 2.844339083698e-9, 1e-21);
    EXPECT_NEAR(n.pair_original.normal, 6.04395604e10, 1e2);
    EXPECT_NEAR(n.pair_original.shear, 1.24434389e10, 1e2);
    EXPECT_NEAR(n.damping, 0.279997993335, 1e-12);
}

TEST(Derived, ReducedModuliAreTheRatioTimesTheOriginal) {
    const DerivedNumbers n = numbers_at("1");
    EXPECT_NEAR(n.pair_reduced.normal, 6.04395604e7, 0.1);
    EXPECT_NEAR(n.pair_reduced.shear, 1.24434389e7, 0.1);
    EXPECT_DOUBLE_EQ(n.wall_reduced.normal, n.pair_reduced.normal);
}

TEST(Derived, RigidWallDoublesTheModulus) {
    const DerivedNumbers n = numbers_at("1", {"contact.wall_modulus=rigid"});
    EXPECT_DOUBLE_EQ(n.wall_original.normal, 2 * n.pair_original.normal);
}

struct CohesionRow {
    const char* bond;
    double hamaker, pair, wall;
};

class DerivedCohesion : public ::testing::TestWithParam<CohesionRow> {};

// The table of docs/physics.md section 5.9; seven digits are printed, so half a unit of the last is at most 4.5e-7.
TEST_P(DerivedCohesion, HamakerConstantAndPullOffForces) {
    const CohesionRow row = GetParam();
    const DerivedNumbers n = numbers_at(row.bond);
    EXPECT_NEAR(n.hamaker_original / row.hamaker, 1, 4.5e-7);
    EXPECT_NEAR(n.pull_off.pair / row.pair, 1, 4.5e-7);
    EXPECT_NEAR(n.pull_off.wall / row.wall, 1, 4.5e-7);
    EXPECT_NEAR(n.bond_number.pair, std::stod(row.bond), 1e-12 * std::stod(row.bond));
    EXPECT_NEAR(n.bond_number.wall, 2 * std::stod(row.bond), 1e-12 * std::stod(row.bond));
    EXPECT_NEAR(n.hamaker_reduced / n.hamaker_original, 0.063096, 5e-7);
}

INSTANTIATE_TEST_SUITE_P(BondNumbers, DerivedCohesion,
                         ::testing::Values(CohesionRow{"0.2", 7.433965e-24, 5.688678e-10, 1.137736e-9},
                                           CohesionRow{"1", 3.716982e-23, 2.844339e-9, 5.688678e-9},
                                           CohesionRow{"5", 1.858491e-22, 1.422170e-8, 2.844339e-8},
                                           CohesionRow{"50", 1.858491e-21, 1.422170e-7, 2.844339e-7},
                                           CohesionRow{"400", 1.486793e-20, 1.137736e-6, 2.275471e-6}));

struct LengthRow {
    const char* bond;
    double paper, printed, wall;
};

class DerivedLength : public ::testing::TestWithParam<LengthRow> {};

// docs/physics.md section 5.9: the paper prints these lengths truncated to two decimals.
TEST_P(DerivedLength, InertialLengthBothWays) {
    const LengthRow row = GetParam();
    const DerivedNumbers n = numbers_at(row.bond);
    testing::verify("with Bo weights on the wall, in diameters", n.inertial_length_paper - row.paper, 6e-7);
    EXPECT_DOUBLE_EQ(std::floor(100 * n.inertial_length_paper) / 100, row.printed);
    testing::verify_relative("with 2 Bo weights on the wall", n.inertial_length_wall, row.wall, 3e-5);
}

INSTANTIATE_TEST_SUITE_P(BondNumbers, DerivedLength,
                         ::testing::Values(LengthRow{"0", 8.494733, 8.49, 8.4947},
                                           LengthRow{"1", 4.247367, 4.24, 2.8316},
                                           LengthRow{"5", 1.415789, 1.41, 0.77225},
                                           LengthRow{"50", 0.166563, 0.16, 0.084106},
                                           LengthRow{"200", 0.042262, 0.04, 0.021184}));

TEST(Derived, WithoutFrictionNothingStopsAParticle) {
    EXPECT_TRUE(std::isinf(numbers_at("5", {"contact.sliding_friction=0"}).inertial_length_paper));
}

}  // namespace
}  // namespace recoat
