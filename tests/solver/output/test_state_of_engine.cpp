#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solver/output/state_of_engine.hpp"
#include "tests/support/fake_engine.hpp"
#include "tests/support/scene_text.hpp"

namespace recoat {
namespace {

using ::testing::ElementsAre;

TEST(StateOfEngine, HasTheParticlesAndTheirCoordination) {
    ParticleTable particles;
    particles.position = {{0, 0.1, 0}, {0, 5.5, 0}, {0, 3, 0}};
    particles.velocity = {{1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
    particles.angular_velocity = {{4, 0, 0}, {0, 5, 0}, {0, 0, 6}};
    particles.radius = {0.3, 0.3, 0.3};
    testing::FakeScript script;
    const testing::FakeEngine engine(script, 0.1, particles, {});
    const State state = state_of_engine(engine, 6);
    EXPECT_THAT(state.id, ElementsAre(0, 1, 2));
    EXPECT_EQ(state.position, particles.position);
    EXPECT_EQ(state.velocity, particles.velocity);
    EXPECT_EQ(state.angular_velocity, particles.angular_velocity);
    EXPECT_EQ(state.radius, particles.radius);
    EXPECT_THAT(state.scalars.at("CoordinationNumber"), ElementsAre(1, 1, 0));
}

TEST(StateInfoOfScene, SaysWhereTheLayerIs) {
    const Scene scene = testing::scene_of(testing::spread_text, {"cohesion.bond_number=5", "seed=4"});
    const StateInfo info = state_info(scene, "heap", Backend::cpu);
    EXPECT_EQ(info.stage, "heap");
    EXPECT_EQ(info.seed, 4);
    EXPECT_EQ(info.config, scene.resolved);
    EXPECT_DOUBLE_EQ(info.diameter, 5e-5);
    EXPECT_DOUBLE_EQ(info.density, 4430);
    EXPECT_EQ(info.y_min, 0);
    EXPECT_NEAR(info.y_period, 6 * 5e-5, 1e-18);
    EXPECT_NEAR(info.clearance, 7.5e-5, 1e-18);
    EXPECT_EQ(info.blade_start, 0);
    EXPECT_NEAR(info.spread_length, 1e-3, 1e-15);
    EXPECT_EQ(info.bond_number, 5);
    EXPECT_DOUBLE_EQ(info.stiffness_ratio, 0.001);
}

TEST(StateInfoOfScene, LeavesOutWhatDoesNotApply) {
    const Scene scene = testing::scene_of(
        "scene: particles\nparticles: a.csv\nduration: 1 ms\nstiffness_ratio: 0.001\n" + testing::model_text);
    const StateInfo info = state_info(scene, "run", Backend::cuda);
    EXPECT_TRUE(std::isnan(info.y_period) && std::isnan(info.clearance) && std::isnan(info.blade_start));
}

}  // namespace
}  // namespace recoat
