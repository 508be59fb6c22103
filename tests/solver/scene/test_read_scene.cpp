#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/error.hpp"
#include "solver/scene/read_scene.hpp"
#include "tests/support/scene_text.hpp"
#include "tests/support/throws_message.hpp"

namespace recoat {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::message_of;
using testing::scene_of;
using testing::spread_text;

std::string refusal(const std::vector<std::string>& settings) {
    return message_of<InputError>([&] { scene_of(spread_text, settings); });
}

TEST(ReadScene, ConvertsUnits) {
    const Scene scene = scene_of(spread_text, {"output.energy_interval=1 us", "output.trajectory_interval=0.1 ms"});
    EXPECT_EQ(scene.kind, "spread");
    EXPECT_DOUBLE_EQ(scene.diameter, 50e-6);
    EXPECT_DOUBLE_EQ(scene.model.youngs_modulus, 110e9);
    EXPECT_DOUBLE_EQ(scene.time_step, 2e-8);
    EXPECT_EQ(scene.output.energy_interval, 50);
    EXPECT_EQ(scene.output.trajectory_interval, 5000);
}

TEST(ReadScene, HamakerConstantAndBondNumberAreTwoNamesOfOneStrength) {
    // docs/physics.md section 1.7: A = Bo 3.716982314576e-23 J
    const Scene by_bond = scene_of(spread_text, {"cohesion.bond_number=50"});
    EXPECT_NEAR(by_bond.model.hamaker / (50 * 3.716982314576e-23), 1, 1e-12);
    const Scene by_hamaker = scene_of(spread_text, {"cohesion.hamaker=3.716982314576e-23 J"});
    EXPECT_NEAR(by_hamaker.bond_number, 1, 1e-12);
    EXPECT_EQ(scene_of(spread_text).model.hamaker, 0);
    EXPECT_EQ(scene_of(spread_text, {"cohesion.bond_number=0"}).model.hamaker, 0);
}

TEST(ReadScene, RefusesTwoStrengthsOrNone) {
    EXPECT_THAT(refusal({"cohesion.bond_number=5", "cohesion.hamaker=1e-20 J"}),
                HasSubstr("either bond_number or hamaker"));
    EXPECT_THAT(refusal({"cohesion.cut_off=50 nm"}), HasSubstr("cohesion.bond_number"));
}

TEST(ReadScene, RefusesImpossibleValuesWithTheirKey) {
    EXPECT_THAT(refusal({"contact.restitution=0"}), HasSubstr("contact.restitution"));
    EXPECT_THAT(refusal({"contact.restitution=1.1"}), HasSubstr("contact.restitution"));
    EXPECT_THAT(refusal({"contact.sliding_friction=-0.1"}), HasSubstr("contact.sliding_friction"));
    EXPECT_THAT(refusal({"material.poisson_ratio=0.6"}), HasSubstr("material.poisson_ratio"));
    EXPECT_THAT(refusal({"material.diameter=0 um"}), HasSubstr("material.diameter"));
    EXPECT_THAT(refusal({"stiffness_ratio=0"}), HasSubstr("stiffness_ratio"));
    EXPECT_THAT(refusal({"stiffness_ratio=2"}), HasSubstr("stiffness_ratio"));
    EXPECT_THAT(refusal({"cohesion.bond_number=1", "cohesion.cut_off=0.1 nm"}), HasSubstr("cohesion.cut_off"));
    EXPECT_THAT(refusal({"cohesion.bond_number=1", "cohesion.cut_off=6 um"}), HasSubstr("0.1 dp"));
    EXPECT_THAT(refusal({"powder.particles=0"}), HasSubstr("powder.particles"));
    EXPECT_THAT(refusal({"powder.packing_density=0.5"}), HasSubstr("powder.packing_density"));
    EXPECT_THAT(refusal({"seed=-1"}), HasSubstr("seed"));
}

TEST(ReadScene, RefusesAMissingUnitAndAMisspeltKey) {
    EXPECT_THAT(refusal({"material.diameter=50"}), AllOf(HasSubstr("material.diameter"), HasSubstr("unit")));
    EXPECT_THAT(refusal({"contact.restitutoin=0.4"}), AllOf(HasSubstr("restitutoin"), HasSubstr("restitution")));
    EXPECT_THAT(refusal({"contact.rolling_form=owned"}), AllOf(HasSubstr("rolling_form"), HasSubstr("own, relative")));
}

TEST(ReadScene, RefusesAnUnstableStepAndSaysWhichLimit) {
    EXPECT_THAT(refusal({"time_step=2e-6 s"}),
                AllOf(HasSubstr("time_step"), HasSubstr("tangential contact frequency")));
    EXPECT_NO_THROW(scene_of(spread_text, {"time_step=1e-6 s"}));
}

TEST(ReadScene, ResolvedConfigurationReadsBackAsItself) {
    const Scene scene = scene_of(spread_text, {"cohesion.bond_number=5"});
    const Scene again = scene_of(scene.resolved);
    EXPECT_EQ(again.resolved, scene.resolved);
    EXPECT_EQ(again.model, scene.model);
    EXPECT_EQ(again.walls, scene.walls);
    ASSERT_EQ(again.stages.size(), scene.stages.size());
    for (std::size_t i = 0; i < scene.stages.size(); ++i) EXPECT_EQ(again.stages[i].segments, scene.stages[i].segments);
    EXPECT_THAT(scene.resolved, HasSubstr("scheme: discrete_gradient"));
}

TEST(ReadScene, EngineSetUpIsThatOfTheScene) {
    const Scene scene = scene_of(spread_text);
    const EngineSetup setup = engine_setup(scene, {Backend::cpu, 3, 0});
    EXPECT_EQ(setup.model, scene.model);
    EXPECT_EQ(setup.gravity, (Vec3{0, 0, -9.81}));
    EXPECT_EQ(setup.time_step, 2e-8);
    EXPECT_EQ(setup.diameter, 50e-6);
    EXPECT_NEAR(setup.y_period, 6 * 50e-6, 1e-18);
    EXPECT_EQ(setup.resources.threads, 3);
}

TEST(ReadScene, ParticlesSleepUnlessTheSceneSaysNo) {
    EXPECT_TRUE(engine_setup(scene_of(spread_text), {}).sleep);
    EXPECT_FALSE(engine_setup(scene_of(spread_text, {"sleep=false"}), {}).sleep);
}

TEST(ReadScene, SkinsOfThePairListsReachTheEngine) {
    EXPECT_EQ(engine_setup(scene_of(spread_text), {}).skins, ListSkins{});
    const Scene scene = scene_of(spread_text, {"pair_lists.skin=10 um", "pair_lists.close_steps=250"});
    EXPECT_DOUBLE_EQ(engine_setup(scene, {}).skins.far, 0.2);
    EXPECT_EQ(engine_setup(scene, {}).skins.close_steps, 250);
    EXPECT_THROW(scene_of(spread_text, {"pair_lists.skin=0.02 dp"}), InputError);
}

}  // namespace
}  // namespace recoat
