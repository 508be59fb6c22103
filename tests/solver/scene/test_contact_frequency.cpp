#include <cmath>

#include <gtest/gtest.h>

#include "solver/contact/material.hpp"
#include "solver/scene/contact_frequency.hpp"
#include "tests/support/paper_model.hpp"

namespace recoat {
namespace {

using testing::paper_model;

constexpr double radius = testing::paper_radius, mass = 2.899428219876e-10;

/// Slope of a force, from differences.
template <class Force>
double slope(const Force& force, double at) {
    const double h = 1e-5 * at;
    return (force(at + h) - force(at - h)) / (2 * h);
}

// docs/physics.md 1.1: E* = 60.44 GPa.
TEST(ContactFrequency, IsThatOfTheHertzSpringWithoutFriction) {
    ContactModel model = paper_model(0.001, 0);
    model.sliding_friction = 0;
    const double overlap = 2e-8;
    const auto pair = [](double d) { return 4.0 / 3 * 6.04395604e7 * std::sqrt(radius / 2) * std::pow(d, 1.5); };
    EXPECT_NEAR(contact_frequency(model, pair_of(radius, radius, 4430), overlap),
                std::sqrt(slope(pair, overlap) / (mass / 2)), 1e-3);
    const auto wall = [](double d) { return 4.0 / 3 * 6.04395604e7 * std::sqrt(radius) * std::pow(d, 1.5); };
    EXPECT_NEAR(contact_frequency(model, with_wall(radius, 4430), overlap), std::sqrt(slope(wall, overlap) / mass),
                1e-3);
}

TEST(ContactFrequency, UnequalSpheresHaveTheirOwnRadiusAndMass) {
    const ContactPartners partners = pair_of(radius, 3 * radius, 4430);
    EXPECT_NEAR(partners.reduced_radius, 0.75 * radius, 1e-18);
    EXPECT_NEAR(partners.reduced_mass, mass * 27 / 28, 1e-21);
}

// The friction spring turns the particle as well as it shifts it: 1/m + R^2/I = 3.5/m. G* = 12.44 GPa.
TEST(ContactFrequency, FrictionIsStifferThanHertz) {
    const ContactModel model = paper_model(1, 0);
    const double spring = 8 * 1.24434389e10 * std::sqrt(radius / 2 * 1e-9);
    EXPECT_NEAR(contact_frequency(model, pair_of(radius, radius, 4430), 1e-9) / std::sqrt(3.5 * spring / (mass / 2)), 1,
                1e-8);
}

TEST(ContactFrequency, AttractionCountsWithItsSteepestSlope) {
    ContactModel model = paper_model(1e-3, 400);
    model.sliding_friction = 0;
    const auto attraction = [&](double s) { return -model.hamaker * radius / 2 / (6 * s * s); };
    EXPECT_NEAR(contact_frequency(model, pair_of(radius, radius, 4430), 1e-9) /
                    std::sqrt(slope(attraction, model.minimum_separation) / (mass / 2)),
                1, 1e-6);
}

// Friction carries the attraction too: a contact without overlap is held by it [docs/physics.md 2.2].
TEST(ContactFrequency, FrictionOfAContactWithoutOverlapIsThatOfItsLoad) {
    const ContactModel model = paper_model(1e-5, 1);
    const double force = 2.844339e-9, hertz = 4.0 / 3 * 6.04395604e5 * std::sqrt(radius / 2);
    const double spring = 8 * 1.24434389e5 * std::sqrt(radius / 2 * std::pow(force / hertz, 2.0 / 3));
    const double well = 2 * force / model.minimum_separation;
    EXPECT_NEAR(contact_frequency(model, pair_of(radius, radius, 4430), 0) /
                    std::sqrt(std::max(3.5 * spring, well) / (mass / 2)),
                1, 1e-6);
}

}  // namespace
}  // namespace recoat
