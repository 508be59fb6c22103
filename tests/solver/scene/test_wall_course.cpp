#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/error.hpp"
#include "tests/support/scene_text.hpp"
#include "tests/support/throws_message.hpp"

namespace recoat {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::message_of;
using testing::scene_of;
using testing::spread_text;

/// Blade from 0 to 4 dp, gate at 10 dp, front end wall at 55 dp, rear end wall at -5 dp. A millisecond at 50 mm/s is a
/// diameter.
std::string with_stages(const std::string& stages, const std::string& blade = "clearance: 1.5 dp, speed: 50 mm/s") {
    std::string text = spread_text.substr(0, spread_text.find("blade:"));
    return text + "blade: {" + blade + "}\nstages:\n" + stages;
}

std::string refusal(const std::string& stages, const std::string& blade = "clearance: 1.5 dp, speed: 50 mm/s") {
    return message_of<InputError>([&] { scene_of(with_stages(stages, blade)); });
}

std::string move(const std::string& wall, const std::string& velocity, const std::string& duration) {
    return "  - move: {wall: " + wall + ", velocity: [" + velocity + "], duration: " + duration + "}\n";
}

const std::string fill_and_heap = "  - fill\n  - heap\n";

TEST(WallCourse, TheGateMustBeGoneBeforeTheBladeComes) {
    EXPECT_THAT(
        refusal("  - fill\n  - spread: {length: 20 dp}\n"),
        AllOf(HasSubstr("stages.1.spread"), HasSubstr("the gate stands in the way of the blade"), HasSubstr("heap")));
    EXPECT_NO_THROW(scene_of(with_stages("  - fill\n  - remove: {wall: gate}\n  - spread: {length: 20 dp}\n")));
    EXPECT_NO_THROW(scene_of(with_stages(fill_and_heap + "  - spread: {length: 20 dp}\n")));
}

TEST(WallCourse, ABladeThatIsMovedMeetsTheGateToo) {
    EXPECT_THAT(refusal("  - fill\n" + move("blade", "50 mm/s, 0 m/s, 0 m/s", "7 ms")),
                HasSubstr("the blade would run into the gate, 1 dp too far"));
    EXPECT_NO_THROW(scene_of(with_stages("  - fill\n" + move("blade", "50 mm/s, 0 m/s, 0 m/s", "5 ms"))));
}

TEST(WallCourse, NothingLeavesTheDomain) {
    for (const char* down : {"0 m/s, 0 m/s, -50 mm/s", "0 m/s, 0 m/s, 50 mm/s"})
        EXPECT_THAT(refusal(fill_and_heap + move("base", down, "1 ms")),
                    HasSubstr("\"base\" may move along x and y only"));
    EXPECT_NO_THROW(scene_of(with_stages(fill_and_heap + move("base", "10 mm/s, 5 mm/s, 0 m/s", "1 ms"))));
    EXPECT_THAT(refusal(fill_and_heap + move("rear", "-10 mm/s, 0 m/s, 0 m/s", "1 ms")), HasSubstr("domain ends"));
    EXPECT_THAT(refusal(fill_and_heap + move("front", "10 mm/s, 0 m/s, 0 m/s", "1 ms")), HasSubstr("domain ends"));
    for (const char* wall : {"base", "rear", "front"})
        EXPECT_THAT(refusal(fill_and_heap + "  - remove: {wall: " + wall + "}\n"),
                    AllOf(HasSubstr("lost"), HasSubstr(wall)));
}

TEST(WallCourse, EndWallsMayComeInAsFarAsTheBlade) {
    EXPECT_NO_THROW(scene_of(with_stages(fill_and_heap + move("rear", "50 mm/s, 0 m/s, 0 m/s", "5 ms"))));
    EXPECT_THAT(refusal(fill_and_heap + move("rear", "50 mm/s, 0 m/s, 0 m/s", "6 ms")),
                HasSubstr("the rear end wall would run into the blade, 1 dp too far"));
    EXPECT_THAT(refusal(fill_and_heap + move("blade", "-50 mm/s, 0 m/s, 0 m/s", "6 ms")),
                AllOf(HasSubstr("the blade would run into the rear end wall"), HasSubstr("box.length")));
}

TEST(WallCourse, TheBladeMustNotGoThroughTheBase) {
    EXPECT_THAT(refusal(fill_and_heap + move("blade", "0 m/s, 0 m/s, -50 mm/s", "1 ms")),
                HasSubstr("the blade would run into the base"));
}

TEST(WallCourse, ABladeAboveItsClearanceIsNotTakenForOneThatIsThere) {
    const std::string spread = fill_and_heap + "  - spread: {length: 20 dp}\n";
    const std::string high = "clearance: 1.5 dp, speed: 50 mm/s, height: 3 dp";
    EXPECT_THAT(refusal(spread, high),
                AllOf(HasSubstr("the blade stands 3 dp above"), HasSubstr("clearance (1.5 dp)")));
    // lowered to its clearance first: 1.5 ms at 50 mm/s
    const std::string lowered = fill_and_heap + move("blade", "0 m/s, 0 m/s, -50 mm/s", "1.5 ms");
    const Scene scene = scene_of(with_stages(lowered + "  - spread: {length: 20 dp}\n", high));
    EXPECT_EQ(scene.stages.at(3).segments.size(), 2U);  // no lift
}

TEST(WallCourse, ABladeThatIsGoneSpreadsNothing) {
    EXPECT_THAT(refusal(fill_and_heap + "  - remove: {wall: blade}\n  - spread: {length: 5 dp}\n"),
                HasSubstr("the blade was taken away"));
}

TEST(WallCourse, PlanesThatFaceEachOtherMustNotMeet) {
    const auto press = [](const std::string& duration) {
        return "scene: particles\nstiffness_ratio: 0.001\nparticles: table.csv\n" + testing::model_text +
               "walls:\n"
               "  - plane: {name: floor, normal: [0, 0, 1]}\n"
               "  - plane: {name: lid, point: [0 m, 0 m, 100 um], normal: [0, 0, -1], velocity: [0 m/s, 0 m/s, -50 "
               "mm/s]}\n"
               "  - plane: {name: side, normal: [1, 0, 0], velocity: [-1 m/s, 0 m/s, 0 m/s]}\n"
               "duration: " +
               duration + "\n";
    };
    EXPECT_NO_THROW(scene_of(press("1.9 ms")));
    EXPECT_THAT(message_of<InputError>([&] { scene_of(press("3 ms")); }),
                HasSubstr("the wall \"lid\" would run into the wall \"floor\", 1 dp too far"));
}

}  // namespace
}  // namespace recoat
