#include <gtest/gtest.h>

#include "common/config.hpp"
#include "common/error.hpp"
#include "tests/support/throws_message.hpp"

namespace recoat {
namespace {

using testing::message_of;

const std::string scene =
    "cohesion:\n  bond_number: 5\n"
    "stages:\n- fill: {time: 1 s}\n- heap\n- spread: {speed: 50 mm/s}\n";

Config with(const std::vector<std::string>& overrides) { return Config::parse(scene, "scene.yaml", overrides); }

std::string refusal(const std::string& text) {
    return message_of<InputError>([&] { (void)with({text}); });
}

TEST(Override, ReplacesAndAddsValues) {
    const auto config = with({"cohesion.bond_number=50", "cohesion.cut_off=2 nm", "a.b.c=3", "box=[1, 2, 3]"});
    EXPECT_EQ(config.section("cohesion").number("bond_number"), 50);
    EXPECT_EQ(config.section("cohesion").quantity("cut_off", Dimension::length), 2e-9);
    EXPECT_EQ(config.section("a").section("b").integer("c"), 3);
    EXPECT_EQ(config.vector("box", Dimension::none), (Vec3{1, 2, 3}));
}

TEST(Override, TheLastOneCounts) {
    EXPECT_EQ(with({"cohesion.bond_number=50", "cohesion.bond_number=7"}).section("cohesion").number("bond_number"), 7);
}

TEST(Override, ReachesItemsOfListsByIndexAndByName) {
    const auto stages =
        with({"stages.0.fill.time=3 s", "stages.heap.time=4 s", "stages.spread.speed=1 mm/s"}).list("stages");
    EXPECT_EQ(stages.at(0).section("fill").quantity("time", Dimension::time), 3);
    EXPECT_EQ(stages.at(1).section("heap").quantity("time", Dimension::time), 4);
    EXPECT_EQ(stages.at(2).section("spread").quantity("speed", Dimension::speed), 1e-3);
}

TEST(Override, ErrorsNameItsText) {
    EXPECT_EQ(message_of<InputError>([] {
                  (void)with({"cohesion.bond_number=-1"}).section("cohesion").number("bond_number", Range::positive());
              }),
              "--set cohesion.bond_number=-1: cohesion.bond_number: -1 is out of range; it must be greater than 0");
    EXPECT_EQ(message_of<InputError>([] {
                  const auto config = with({"cohesion.bond_numbr=1"});
                  (void)config.section("cohesion").number("bond_number");
                  (void)config.list("stages");
                  config.finish();
              }),
              "--set cohesion.bond_numbr=1: cohesion.bond_numbr: the key is unknown; did you mean \"bond_number\"?");
}

TEST(Override, MalformedOnesAreRefused) {
    EXPECT_EQ(refusal("cohesion"), "--set cohesion: this has no form; write key.key=value");
    EXPECT_EQ(refusal("=3"), "--set =3: this has no form; write key.key=value");
    EXPECT_EQ(refusal("a..b=3"), "--set a..b=3: a part of the key is empty; write key.key=value");
    EXPECT_EQ(refusal("stages.7.fill=3"), "--set stages.7.fill=3: the list has no item 7; it has 3, counted from 0");
    EXPECT_EQ(refusal("stages.melt.time=3"),
              "--set stages.melt.time=3: no item of the list is called melt; give the index, counted from 0");
    EXPECT_EQ(refusal("cohesion.bond_number.x=3"),
              "--set cohesion.bond_number.x=3: x is below a plain value, which has no keys; shorten the path");
    EXPECT_EQ(refusal("a=[1"),
              "--set a=[1: the value is not valid YAML (end of sequence flow not found); check its quotes and "
              "brackets");
}

TEST(Resolved, HoldsOverridesAndDefaultsAndReadsBackTheSame) {
    const auto read = [](const Config& config) {
        (void)config.section("cohesion").number("bond_number");
        (void)config.section("cohesion").quantity_or("cut_off", Dimension::length, 1e-7);
        (void)config.section_or_empty("contact").boolean_or("capped", true);
        (void)config.vector_or("gravity", Dimension::acceleration, {0, 0, -9.81});
        for (const auto& stage : config.list("stages")) {
            (void)stage.section(stage.keys().at(0)).quantity_or("time", Dimension::time, 2);
        }
        return config.resolved();
    };
    const std::string resolved = read(with({"cohesion.bond_number=50"}));
    EXPECT_EQ(resolved,
              "cohesion:\n  bond_number: 50\n  cut_off: 1e-07 m\n"
              "stages:\n  - fill:\n      time: 1 s\n  - heap:\n      time: 2 s\n"
              "  - spread:\n      speed: 50 mm/s\n      time: 2 s\n"
              "contact:\n  capped: true\ngravity:\n  - 0 m/s2\n  - 0 m/s2\n  - -9.81 m/s2\n");
    EXPECT_EQ(read(Config::parse(resolved, "again.yaml")), resolved);
}

TEST(Resolved, KeepsTextsThatNeedQuotes) {
    const auto config = Config::parse("a: \"x: y # z\"\nb: 'true'\nc: \"\"\nd:\n", "a.yaml");
    const auto again = Config::parse(config.resolved(), "again.yaml");
    EXPECT_EQ(again.text("a"), "x: y # z");
    EXPECT_EQ(again.text("b"), "true");
    EXPECT_EQ(again.text("c"), "");
    EXPECT_TRUE(again.has("d"));
}

}  // namespace
}  // namespace recoat
