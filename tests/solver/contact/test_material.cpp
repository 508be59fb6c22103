#include <gtest/gtest.h>

#include "solver/contact/coefficients.hpp"
#include "solver/contact/material.hpp"
#include "tests/support/paper_model.hpp"
#include "tests/support/verification.hpp"

namespace recoat {
namespace {

using testing::paper_model;
using testing::paper_radius;
using testing::verify_relative;

void expect_relative(double value, double expected, double tolerance) {
    EXPECT_NEAR(value, expected, tolerance * std::fabs(expected));
}

// Numbers of docs/physics.md section 1.1, worked out by hand from Table 1 of the paper.
TEST(Material, DerivedNumbersOfThePaper) {
    const ContactModel model = paper_model(1, 0);
    const double mass = sphere_mass(paper_radius, model.density);
    expect_relative(mass, 2.899428219876e-10, 1e-12);
    expect_relative(sphere_inertia(mass, paper_radius), 7.248570549689e-20, 1e-12);
    const EffectiveModuli pair = pair_moduli(model.youngs_modulus, model.poisson_ratio);
    expect_relative(pair.normal, 6.04395604e10, 4e-9);
    expect_relative(pair.shear, 1.24434389e10, 4e-9);
}

TEST(Material, WallsAreElasticOrRigid) {
    const EffectiveModuli pair = pair_moduli(110e9, 0.3);
    const EffectiveModuli elastic = wall_moduli(110e9, 0.3, WallModulus::elastic);
    const EffectiveModuli rigid = wall_moduli(110e9, 0.3, WallModulus::rigid);
    expect_relative(elastic.normal, pair.normal, 1e-15);
    // A rigid partner adds no compliance: E* is that of the particle alone.
    expect_relative(rigid.normal, 110e9 / (1 - 0.09), 1e-14);
    expect_relative(rigid.shear, 110e9 / (2 * 1.7 * 1.3), 1e-14);
}

// sqrt(5) beta for six coefficients of restitution [docs/physics.md section 5.3].
TEST(Material, DampingOfTheRestitutionTable) {
    const double table[][2] = {{0.1, 1.3218628408}, {0.2, 1.0195347712}, {0.4, 0.6260945467},
                               {0.6, 0.3588733623}, {0.8, 0.1584260875}, {0.9, 0.0749495307}};
    for (const auto& [restitution, alpha] : table)
        verify_relative("sqrt(5) beta", std::sqrt(5.0) * damping_coefficient(restitution), alpha, 1e-9);
    EXPECT_EQ(damping_coefficient(1), 0);
}

struct Strength {
    double bond, hamaker, pair, wall;
};

// Hamaker constants and pull-off forces [docs/physics.md section 5.9].
TEST(Material, HamakerConstantsOfTheBondNumbers) {
    const Strength table[] = {
        {0.2, 7.433965e-24, 5.688678e-10, 1.137736e-9}, {0.6, 2.230189e-23, 1.706603e-9, 3.413207e-9},
        {1, 3.716982e-23, 2.844339e-9, 5.688678e-9},    {5, 1.858491e-22, 1.422170e-8, 2.844339e-8},
        {50, 1.858491e-21, 1.422170e-7, 2.844339e-7},   {100, 3.716982e-21, 2.844339e-7, 5.688678e-7},
        {200, 7.433965e-21, 5.688678e-7, 1.137736e-6},  {400, 1.486793e-20, 1.137736e-6, 2.275471e-6}};
    for (const Strength& row : table) {
        const double hamaker = hamaker_from_bond(row.bond, paper_radius, 4430, 9.81, 1.65e-10);
        verify_relative("Hamaker constant", hamaker, row.hamaker, 5e-7);
        verify_relative("force of a pair", pull_off_force(hamaker, 0.5 * paper_radius, 1.65e-10), row.pair, 5e-7);
        verify_relative("force of a wall", pull_off_force(hamaker, paper_radius, 1.65e-10), row.wall, 5e-7);
        expect_relative(bond_from_hamaker(hamaker, paper_radius, 4430, 9.81, 1.65e-10), row.bond, 1e-14);
    }
}

// Scaled so that the work of the attraction over the softened contact stays the same [docs/physics.md section 2.1].
TEST(Material, AttractionScalesWithTheOverlap) {
    expect_relative(attraction_scaling(0.1), 0.398107, 1e-6);
    expect_relative(attraction_scaling(0.01), 0.158489, 1e-5);
    expect_relative(attraction_scaling(0.001), 0.0630957, 1e-6);
    EXPECT_EQ(attraction_scaling(1), 1);
}

}  // namespace
}  // namespace recoat
