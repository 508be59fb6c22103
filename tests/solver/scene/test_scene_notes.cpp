#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solver/scene/scene_notes.hpp"
#include "tests/support/scene_text.hpp"

namespace recoat {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::scene_of;
using testing::spread_text;

/// Of the usual scene with enough powder for its blade.
std::vector<std::string> notes(std::vector<std::string> settings) {
    settings.insert(settings.begin(), "powder.particles=400");
    return scene_notes(scene_of(spread_text, settings));
}

TEST(SceneNotes, TheUsualIsNotWorthAWord) {
    EXPECT_THAT(notes({}), IsEmpty());
    EXPECT_THAT(notes({"cohesion.bond_number=400"}), IsEmpty());
    EXPECT_THAT(notes({"stiffness_ratio=1", "time_step=auto"}), IsEmpty());
}

TEST(SceneNotes, SpheresAsSoftAsJelly) {
    EXPECT_THAT(notes({"stiffness_ratio=1e-9"}),
                ElementsAre(AllOf(HasSubstr("too soft"), HasSubstr("the run stops at 0.25"))));
    EXPECT_THAT(notes({"stiffness_ratio=1e-7"}),
                ElementsAre(HasSubstr("when they meet at 50 mm/s; the contact law holds")));
    // The closed form below reaches 0.05 of the radius at Bo = 2.2e6.
    EXPECT_THAT(notes({"cohesion.bond_number=2.1e6"}), IsEmpty());
    EXPECT_THAT(notes({"cohesion.bond_number=2.4e6"}),
                ElementsAre(HasSubstr("under their attraction and the powder above")));
    EXPECT_THAT(notes({"material.young_modulus=110 Pa", "stiffness_ratio=1", "time_step=auto"}),
                ElementsAre(AllOf(HasSubstr("young_modulus of 110 Pa"), HasSubstr("give a larger young_modulus"))));
}

// The overlap of an impact without damping: (15 m* v^2/(16 E* sqrt(R*)))^(2/5).
TEST(SceneNotes, OverlapIsThatOfAnImpact) {
    const Scene scene = scene_of(spread_text);
    const double radius = 25e-6, mass = 2.899428219876e-10, modulus = 6.04395604e7;
    const double overlap = std::pow(15 * 0.5 * mass * 0.05 * 0.05 / (16 * modulus * std::sqrt(0.5 * radius)), 0.4);
    EXPECT_NEAR(expected_overlap(scene), overlap / radius, 1e-6 * overlap / radius);
}

// Attraction at rest: Hertz' force holds the pull-off force, scaled with the stiffness.
TEST(SceneNotes, OverlapIsThatOfStrongAttraction) {
    const Scene scene = scene_of(spread_text, {"cohesion.bond_number=1e5", "powder.particles=1"});
    const double radius = 25e-6, weight = 2.844339083698e-9, modulus = 6.04395604e7;
    const double force = std::pow(0.001, 0.4) * 1e5 * weight;
    const double overlap = std::pow(force / (4.0 / 3 * modulus * std::sqrt(0.5 * radius)), 2.0 / 3);
    EXPECT_NEAR(expected_overlap(scene), overlap / radius, 1e-4 * overlap / radius);
}

TEST(SceneNotes, ABladeThatNothingPassesUnder) {
    EXPECT_THAT(notes({"blade.clearance=0.5 dp"}),
                ElementsAre(AllOf(HasSubstr("no particle passes"), HasSubstr("25 um"))));
    const std::vector<std::string> sizes = {
        "powder.sizes.distribution=normal", "powder.sizes.mean=50 um",    "powder.sizes.standard_deviation=10 um",
        "powder.sizes.smallest=30 um",      "powder.sizes.largest=80 um", "box.width=8 dp"};
    EXPECT_THAT(notes(sizes), ElementsAre(AllOf(HasSubstr("the largest particles do not pass"), HasSubstr("80 um"))));
}

// 40 spheres fill about 40 pi/6/0.5 = 42 dp3 over 6 dp times 6 dp.
TEST(SceneNotes, ABladeThatPassesAboveThePowder) {
    EXPECT_THAT(notes({"powder.particles=40", "blade.clearance=1.2 dp"}),
                ElementsAre(AllOf(HasSubstr("passes above the powder"), HasSubstr("60 um"))));
    EXPECT_THAT(notes({"powder.particles=40", "blade.clearance=1.1 dp"}), IsEmpty());
}

TEST(SceneNotes, ARestThatIsNone) {
    // sqrt(2 0.5 g d)
    EXPECT_THAT(notes({"stages.heap.settle_energy=0.5"}),
                ElementsAre(AllOf(HasSubstr("stage heap"), HasSubstr("22.15 mm/s"))));
    EXPECT_THAT(notes({"stages.heap.settle_energy=0.1"}), IsEmpty());
}

TEST(SceneNotes, MaterialsInAnotherUnit) {
    EXPECT_THAT(notes({"material.density=4430 g/cm3"}), ElementsAre(HasSubstr("check the unit")));
    EXPECT_THAT(notes({"material.young_modulus=110000 GPa"}), ElementsAre(HasSubstr("more than that of diamond")));
}

TEST(SceneNotes, SizesFarFromTheDiameterOfTheMaterial) {
    const auto with_sizes = [](double smallest, double largest) {
        Scene scene = scene_of(spread_text, {"blade.clearance=100 dp", "powder.particles=40000"});
        scene.smallest_diameter = smallest;
        scene.largest_diameter = largest;
        return scene_notes(scene);
    };
    EXPECT_THAT(with_sizes(30e-6, 75e-6), IsEmpty());
    EXPECT_THAT(with_sizes(4e-6, 50e-6),
                ElementsAre(HasSubstr("measure 4 um to 50 um, far from material.diameter (50 um)")));
    EXPECT_THAT(with_sizes(10e-6, 20e-6), ElementsAre(HasSubstr("far from material.diameter")));
    EXPECT_THAT(with_sizes(80e-6, 90e-6), ElementsAre(HasSubstr("far from material.diameter")));
    EXPECT_THAT(with_sizes(50e-6, 250e-6), ElementsAre(HasSubstr("far from material.diameter")));
    EXPECT_THAT(with_sizes(40e-3, 40e-3),
                ElementsAre(HasSubstr("no particle passes"), HasSubstr("measure 40 mm, far")));
}

}  // namespace
}  // namespace recoat
