#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/error.hpp"
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

constexpr double dt = 2e-8;
constexpr double d = 50e-6;

std::string with_stages(const std::string& stages) {
    return spread_text.substr(0, spread_text.find("stages:")) + "stages:\n" + stages;
}

std::string refusal(const std::string& stages) {
    return message_of<InputError>([&] { scene_of(with_stages(stages)); });
}

TEST(Stages, FillSettlesBelowTheStatedEnergy) {
    const Scene scene = scene_of(spread_text, {"stages.fill.settle_energy=1e-4"});
    const Stage& fill = scene.stages.at(0);
    EXPECT_EQ(fill.kind, "fill");
    ASSERT_EQ(fill.segments.size(), 1U);
    EXPECT_EQ(fill.segments[0].steps, 500000);
    ASSERT_TRUE(fill.segments[0].rest);
    // docs/physics.md section 1.1: m g = 2.844339083698e-9 N
    EXPECT_NEAR(fill.segments[0].rest->energy, 1e-4 * 2.844339083698e-9 * d, 1e-29);
    EXPECT_TRUE(fill.may_end_early());
}

TEST(Stages, WhatSettlesByDefault) {
    const Scene scene = scene_of(with_stages("  - fill\n  - heap\n  - spread: {length: 10 dp}\n"));
    const double unit = 2.844339083698e-9 * d;
    const Segment fill = scene.stages.at(0).segments.at(0), heap = scene.stages.at(1).segments.at(0);
    const Segment spread = scene.stages.at(2).segments.at(2);
    EXPECT_NEAR(fill.rest->energy / unit, 1e-6, 1e-14);
    EXPECT_NEAR(heap.rest->energy / unit, 1e-4, 1e-12);
    EXPECT_NEAR(spread.rest->energy / unit, 1e-4, 1e-12);
    EXPECT_EQ(fill.steps, 10'000'000);
    EXPECT_EQ(heap.steps, 25'000'000);
    // a particle falls its diameter in sqrt(2 d_p/g) = 3.193 ms; ten checks cover a third of it
    EXPECT_NEAR(static_cast<double>(10 * fill.rest->interval) * dt, 3.193e-3 / 3, 1e-6);
}

// For the last few spheres that roll nobody waits, unless the scene says so; a bed has to be at rest.
TEST(Stages, StragglersMayStillMove) {
    const Scene usual = scene_of(with_stages("  - fill\n  - heap\n  - spread: {length: 10 dp}\n  - settle\n"));
    EXPECT_EQ(usual.stages.at(0).segments.at(0).rest->stragglers, 0);
    EXPECT_EQ(usual.stages.at(1).segments.at(0).rest->stragglers, std::nullopt);
    EXPECT_EQ(usual.stages.at(2).segments.at(2).rest->stragglers, std::nullopt);
    EXPECT_EQ(usual.stages.at(3).segments.at(0).rest->stragglers, 0);
    const Scene other = scene_of(with_stages("  - fill: {stragglers: auto}\n  - heap: {stragglers: 12}\n"));
    EXPECT_EQ(other.stages.at(0).segments.at(0).rest->stragglers, std::nullopt);
    EXPECT_EQ(other.stages.at(1).segments.at(0).rest->stragglers, 12);
    EXPECT_THAT(refusal("  - fill: {stragglers: -1}\n"), HasSubstr("stragglers"));
    EXPECT_THAT(refusal("  - fill: {stragglers: few}\n"), HasSubstr("stragglers"));
    EXPECT_EQ(RestCriterion::stragglers_among(15), 0);
    EXPECT_EQ(RestCriterion::stragglers_among(800), 7);
    EXPECT_EQ(RestCriterion::stragglers_among(100000), 79);
}

TEST(Stages, HeapTakesTheGateAway) {
    const Stage heap = scene_of(spread_text).stages.at(1);
    EXPECT_THAT(heap.segments.at(0).removed, ElementsAre("gate"));
    EXPECT_EQ(heap.segments[0].steps, 1000000);
}

TEST(Stages, SpreadLiftsThenMovesThenSettles) {
    const Scene scene = scene_of(spread_text);
    const Stage& spread = scene.stages.at(2);
    ASSERT_EQ(spread.segments.size(), 3U);
    const auto distance = [](const Segment& s) {
        return static_cast<double>(s.steps) * dt * norm(s.motions.at(0).velocity);
    };
    EXPECT_NEAR(distance(spread.segments[0]), 1.5 * d, 1e-16);
    EXPECT_GT(spread.segments[0].motions[0].velocity.z, 0);
    EXPECT_EQ(spread.segments[0].steps, 75000);
    EXPECT_NEAR(distance(spread.segments[1]), 20 * d, 1e-15);
    EXPECT_GT(spread.segments[1].motions[0].velocity.x, 0);
    EXPECT_EQ(spread.segments[1].steps, 1000000);
    EXPECT_TRUE(spread.segments[2].rest);
    EXPECT_TRUE(spread.segments[2].motions.empty());
    EXPECT_EQ(spread.steps(), 75000 + 1000000 + 250000);
}

TEST(Stages, DistancesAreExactWhereTheTimeIsNoMultipleOfTheStep) {
    const Scene scene = scene_of(spread_text, {"blade.speed=47.3 mm/s", "blade.lift_speed=3.33 mm/s"});
    const Stage& spread = scene.stages.at(2);
    for (std::size_t i : {0U, 1U}) {
        const Segment& segment = spread.segments[i];
        const double way = static_cast<double>(segment.steps) * dt * norm(segment.motions[0].velocity);
        EXPECT_NEAR(way, i == 0 ? 1.5 * d : 20 * d, 1e-15);
    }
    EXPECT_NEAR(spread.segments[1].motions[0].velocity.x, 47.3e-3, 1e-7);
}

TEST(Stages, ASecondSpreadDoesNotLiftAgainAndLengthsAddUp) {
    const Scene scene =
        scene_of(with_stages("  - fill\n  - heap\n  - spread: {length: 10 dp}\n  - spread: {length: 5 dp}\n"));
    EXPECT_EQ(scene.stages.at(2).segments.size(), 3U);
    EXPECT_EQ(scene.stages.at(3).segments.size(), 2U);
    EXPECT_EQ(scene.stages.at(3).name, "spread-2");
    EXPECT_NEAR(scene.spread->length, 15 * d, 1e-15);
}

TEST(Stages, GenericStagesBuildAnyRun) {
    const Scene scene =
        scene_of(with_stages("  - fill\n"
                             "  - remove: {wall: gate}\n"
                             "  - move: {wall: blade, velocity: [0 m/s, 0 m/s, 10 mm/s], duration: 2 ms}\n"
                             "  - settle: {settle_time: 1 ms, name: calm}\n"
                             "  - run: {duration: 1 ms}\n"));
    ASSERT_EQ(scene.stages.size(), 5U);
    EXPECT_THAT(scene.stages[1].segments.at(0).removed, ElementsAre("gate"));
    EXPECT_EQ(scene.stages[1].steps(), 0);
    EXPECT_EQ(scene.stages[2].segments.at(0).motions.at(0), (WallMotion{"blade", {0, 0, 0.01}}));
    EXPECT_EQ(scene.stages[2].steps(), 100000);
    EXPECT_EQ(scene.stages[3].name, "calm");
    EXPECT_FALSE(scene.stages[4].may_end_early());
}

TEST(Stages, RefusesWhatCannotBe) {
    EXPECT_THAT(refusal("  - heap\n"), HasSubstr("begin with fill"));
    EXPECT_THAT(refusal("  - fill\n  - fill\n"), HasSubstr("only be the first stage"));
    EXPECT_THAT(refusal("  - fill\n  - bake\n"), HasSubstr("a stage is one of fill, heap"));
    EXPECT_THAT(refusal("  - fill\n  - remove: {wall: door}\n"), HasSubstr("no wall \"door\""));
    EXPECT_THAT(refusal("  - fill\n  - heap\n  - remove: {wall: gate}\n"), HasSubstr("no wall \"gate\""));
    EXPECT_THAT(refusal("  - fill: {name: a b}\n"), HasSubstr("letters, digits"));
    EXPECT_THAT(refusal("  - fill: {name: x}\n  - heap: {name: x}\n"), HasSubstr("taken"));
    EXPECT_THAT(refusal("  - fill: {settle_tim: 1 ms}\n"), HasSubstr("settle_time"));
    EXPECT_THAT(refusal("  - fill\n  - heap\n  - spread: {lenght: 30 dp}\n"), HasSubstr("did you mean \"length\"?"));
    EXPECT_THAT(refusal("  - fill\n  - heap\n  - spread: {length: 30 dp, settel_time: 1 ms}\n"),
                HasSubstr("did you mean \"settle_time\"?"));
    EXPECT_THAT(message_of<InputError>([] { scene_of(with_stages("  []\n")); }), HasSubstr("empty"));
}

}  // namespace
}  // namespace recoat
