#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/error.hpp"
#include "solver/scene/spread_scene.hpp"
#include "tests/support/scene_text.hpp"
#include "tests/support/throws_message.hpp"

namespace recoat {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::message_of;
using testing::model_text;
using testing::scene_of;
using testing::spread_text;

constexpr double d = 50e-6;

const Wall& wall(const Scene& scene, const std::string& name) {
    for (const Wall& candidate : scene.walls) {
        if (candidate.name == name) return candidate;
    }
    throw std::runtime_error("no wall " + name);
}

std::vector<std::string> names(const Scene& scene) {
    std::vector<std::string> result;
    for (const Wall& each : scene.walls) result.push_back(each.name);
    return result;
}

TEST(SpreadScene, WallsStandWhereTheBoxAndTheBladeSay) {
    const Scene scene = scene_of(spread_text);
    EXPECT_THAT(names(scene), ElementsAre("base", "rear", "front", "blade", "gate"));
    EXPECT_EQ(wall(scene, "base").point, Vec3{});
    EXPECT_EQ(wall(scene, "base").normal, (Vec3{0, 0, 1}));
    EXPECT_NEAR(wall(scene, "rear").point.x, -5 * d, 1e-15);
    EXPECT_EQ(wall(scene, "rear").normal, (Vec3{1, 0, 0}));
    EXPECT_NEAR(wall(scene, "front").point.x, 55 * d, 1e-15);
    EXPECT_EQ(wall(scene, "front").normal, (Vec3{-1, 0, 0}));
    EXPECT_NEAR(wall(scene, "gate").point.x, 10 * d, 1e-15);
    EXPECT_EQ(wall(scene, "gate").normal, (Vec3{-1, 0, 0}));
}

TEST(SpreadScene, BladeRestsOnTheBaseAndIsEndlessInYAndUpwards) {
    const Wall blade = wall(scene_of(spread_text), "blade");
    EXPECT_EQ(blade.kind, WallKind::box);
    EXPECT_EQ(blade.lower.x, 0);
    EXPECT_EQ(blade.lower.z, 0);
    EXPECT_NEAR(blade.upper.x, 4 * d, 1e-18);
    EXPECT_TRUE(std::isinf(blade.upper.z) && std::isinf(blade.upper.y) && std::isinf(blade.lower.y));
}

TEST(SpreadScene, PaperCaseIsTheDefaultGeometry) {
    const Scene scene = scene_of("scene: spread\nstiffness_ratio: 0.001\n" + model_text +
                                 "powder: {particles: 100000}\nblade: {clearance: 1.5 dp, speed: 50 mm/s}\n"
                                 "stages: [fill, heap, spread]\n");
    EXPECT_NEAR(wall(scene, "front").point.x - wall(scene, "rear").point.x, 600 * d, 1e-12);
    EXPECT_NEAR(scene.y_period, 40 * d, 1e-12);
    const auto& column = std::get<ColumnSource>(scene.source);
    EXPECT_NEAR(column.x_upper - column.x_lower, 40 * d, 1e-12);
    EXPECT_EQ(column.count, 100000);
    EXPECT_NEAR(scene.spread->length, 500 * d, 1e-12);
    EXPECT_NEAR(scene.spread->clearance, 1.5 * d, 1e-15);
    EXPECT_DOUBLE_EQ(scene.reference_speed, 0.05);
}

TEST(SpreadScene, StartsFromAState) {
    const std::string text = "scene: spread\nstart_from: heap.vtkhdf\nstiffness_ratio: 0.001\n" + model_text +
                             "blade: {clearance: 1.5 dp, speed: 50 mm/s}\nstages: [spread]\n";
    const Scene scene = scene_of(text, {}, "/folder");
    EXPECT_EQ(std::get<StateSource>(scene.source).file, "/folder/heap.vtkhdf");
    EXPECT_THAT(names(scene), ElementsAre("base", "rear", "front", "blade"));
    EXPECT_THAT(message_of<InputError>([&] { scene_of(text + "powder: {particles: 3}\n"); }), HasSubstr("powder"));
}

TEST(SpreadScene, RefusesABoxThatIsTooSmall) {
    const auto refusal = [](const std::string& setting) {
        return message_of<InputError>([&] { scene_of(spread_text, {setting}); });
    };
    EXPECT_THAT(refusal("box.length=28 dp"), HasSubstr("front end wall"));
    EXPECT_THAT(refusal("box.fill_length=56 dp"), HasSubstr("gate"));
    EXPECT_THAT(refusal("box.width=3 dp"), HasSubstr("box.width"));
    EXPECT_THAT(refusal("gravity=0 m/s2"), HasSubstr("gravity"));
}

}  // namespace
}  // namespace recoat
