#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/error.hpp"
#include "solver/scene/particle_scene.hpp"
#include "tests/support/scene_text.hpp"
#include "tests/support/throws_message.hpp"

namespace recoat {
namespace {

using ::testing::HasSubstr;
using testing::message_of;
using testing::model_text;
using testing::scene_of;

const std::string text =
    "scene: particles\nstiffness_ratio: 0.001\n" + model_text +
    "particles: two.csv\nduration: 1 ms\n"
    "walls:\n"
    "  - plane: {name: floor, normal: [0, 0, 2]}\n"
    "  - box: {name: lid, lower: [-inf, -inf, 1 mm], upper: [inf, inf, 2 mm], velocity: [0 m/s, 0 m/s, -2 mm/s]}\n";

std::string refusal(const std::string& more, const std::vector<std::string>& settings = {}) {
    return message_of<InputError>([&] { scene_of(text + more, settings); });
}

TEST(ParticleScene, ReadsWallsAndDuration) {
    const Scene scene = scene_of(text, {}, "/folder");
    EXPECT_EQ(std::get<TableSource>(scene.source).file, "/folder/two.csv");
    ASSERT_EQ(scene.walls.size(), 2U);
    EXPECT_EQ(scene.walls[0].normal, (Vec3{0, 0, 1}));
    EXPECT_EQ(scene.walls[1].kind, WallKind::box);
    EXPECT_TRUE(std::isinf(scene.walls[1].lower.x));
    EXPECT_DOUBLE_EQ(scene.walls[1].lower.z, 1e-3);
    EXPECT_EQ(scene.walls[1].velocity, (Vec3{0, 0, -0.002}));
    EXPECT_DOUBLE_EQ(scene.reference_speed, 0.002);
    ASSERT_EQ(scene.stages.size(), 1U);
    EXPECT_EQ(scene.stages[0].steps(), 50000);
    EXPECT_EQ(scene.y_period, 0);
}

TEST(ParticleScene, GravityMayBeOffAndTheBondNumberKeepsItsMeaning) {
    const Scene scene = scene_of(text, {"gravity=0 m/s2", "cohesion.bond_number=1"});
    EXPECT_EQ(scene.gravity, 0);
    EXPECT_NEAR(scene.model.hamaker, 3.716982314576e-23, 1e-34);
}

TEST(ParticleScene, RefusesWhatContradictsItself) {
    EXPECT_THAT(refusal("start_from: a.vtkhdf\n"), HasSubstr("either particles"));
    EXPECT_THAT(refusal("stages: [settle]\n"), HasSubstr("either duration or stages"));
    EXPECT_THAT(refusal("", {"walls.1.box.name=floor"}), HasSubstr("two walls"));
    EXPECT_THAT(refusal("", {"walls.0.plane.normal=[0, 0, 0]"}), HasSubstr("normal is zero"));
    EXPECT_THAT(refusal("", {"y_period=1 um"}), HasSubstr("y_period"));
    EXPECT_THAT(refusal("blade: {}\n"), HasSubstr("blade"));
    EXPECT_THAT(
        message_of<InputError>([] {
            scene_of("scene: particles\nstiffness_ratio: 0.001\n" + model_text + "particles: a.csv\nstages: [heap]\n");
        }),
        HasSubstr("scene: spread"));
}

}  // namespace
}  // namespace recoat
