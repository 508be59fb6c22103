#include <array>

#include <gtest/gtest.h>

#include "common/config.hpp"
#include "common/error.hpp"
#include "common/output_file.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/throws_message.hpp"

namespace recoat {
namespace {

using testing::message_of;

Config parse(const std::string& text) { return Config::parse(text, "scene.yaml"); }

template <class Action>
std::string refusal(const std::string& text, const Action& read) {
    return message_of<InputError>([&] { read(parse(text)); });
}

constexpr std::array<std::string_view, 2> rolling_forms = {"own", "relative"};

TEST(Config, ReadsEveryKindOfValue) {
    const auto config = parse(
        "size: 50 um\nbond: 1e-3\ncount: 2000\nperiodic: true\nname: heap\nform: own\n"
        "box: [1 mm, 0, -2e-3 m]\nspeeds: [1 m/s, 20 mm/s]\nnames: [a, b]\n");
    EXPECT_EQ(config.quantity("size", Dimension::length), 50e-6);
    EXPECT_EQ(config.number("bond"), 1e-3);
    EXPECT_EQ(config.integer("count"), 2000);
    EXPECT_TRUE(config.boolean_or("periodic", false));
    EXPECT_EQ(config.text("name"), "heap");
    EXPECT_EQ(config.choice("form", rolling_forms), "own");
    EXPECT_EQ(config.vector("box", Dimension::length), (Vec3{1e-3, 0, -2e-3}));
    EXPECT_EQ(config.quantities("speeds", Dimension::speed), (std::vector{1.0, 20e-3}));
    EXPECT_EQ(config.texts("names"), (std::vector<std::string>{"a", "b"}));
    EXPECT_NO_THROW(config.finish());
}

TEST(Config, FallbacksStandInForAbsentKeysOnly) {
    const auto config = parse("a: 1 m\n");
    EXPECT_EQ(config.quantity_or("a", Dimension::length, 9), 1);
    EXPECT_EQ(config.quantity_or("b", Dimension::length, 9), 9);
    EXPECT_EQ(config.integer_or("c", 3), 3);
    EXPECT_EQ(config.text_or("d", "x"), "x");
    EXPECT_EQ(config.choice_or("e", rolling_forms, "relative"), "relative");
    EXPECT_EQ(config.vector_or("f", Dimension::length, {1, 2, 3}), (Vec3{1, 2, 3}));
    EXPECT_FALSE(config.boolean_or("g", false));
}

TEST(Config, WordInPlaceOfAValue) {
    const auto config = parse("step: auto\nlist: [auto]\n");
    EXPECT_TRUE(config.is_word("step", "auto"));
    EXPECT_FALSE(config.is_word("step", "none"));
    EXPECT_FALSE(config.is_word("list", "auto"));
    EXPECT_FALSE(config.is_word("absent", "auto"));
}

TEST(Config, SettledValueIsReadAndResolvedInItsPlace) {
    const auto config = parse("first: 1\nstep: auto\n");
    config.settle("step", "2e-08 s");
    config.settle("skin", "5 um");
    EXPECT_EQ(config.quantity("step", Dimension::time), 2e-8);
    EXPECT_EQ(config.quantity("skin", Dimension::length), 5e-6);
    EXPECT_EQ(config.integer("first"), 1);
    EXPECT_EQ(config.resolved(), "first: 1\nstep: 2e-08 s\nskin: 5 um\n");
    EXPECT_NO_THROW(config.finish());
}

TEST(Config, ReadsJson) {
    auto config =
        Config::parse(R"({"d_p": 5e-05, "analysis": {"window": [0, 0.01], "on": true}, "text": "a b"})", "a.json");
    config.set_plain_is_si(true);
    EXPECT_EQ(config.quantity("d_p", Dimension::length), 5e-5);
    EXPECT_EQ(config.section("analysis").quantities("window", Dimension::length, 2), (std::vector{0, 0.01}));
    EXPECT_TRUE(config.section("analysis").boolean("on"));
    EXPECT_EQ(config.text("text"), "a b");
    EXPECT_NO_THROW(config.finish());
}

TEST(Config, DiametersHoldForTheWholeFile) {
    auto config = parse("heap:\n  height: 3 dp\n");
    config.set_particle_diameter(2e-3);
    EXPECT_EQ(config.section("heap").quantity("height", Dimension::length), 6e-3);
}

TEST(Config, InfinityIsAllowedWhereAsked) {
    const auto config = parse("a: [-inf, .inf, 0]\n");
    const Vec3 corner = config.vector("a", Dimension::length, true);
    EXPECT_EQ(corner, (Vec3{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), 0}));
    EXPECT_THROW((void)config.vector("a", Dimension::length), InputError);
}

TEST(Config, ListsHoldMappingsAndBareWords) {
    const auto config = parse("stages:\n- fill: {time: 1 s}\n- heap\n- spread:\n");
    const auto stages = config.list("stages");
    ASSERT_EQ(stages.size(), 3U);
    EXPECT_EQ(stages[0].section("fill").quantity("time", Dimension::time), 1);
    EXPECT_EQ(stages[1].keys(), std::vector<std::string>{"heap"});
    EXPECT_EQ(stages[1].section("heap").quantity_or("time", Dimension::time, 4), 4);
    EXPECT_EQ(stages[2].section("spread").keys(), std::vector<std::string>{});
    EXPECT_EQ(stages[0].section("fill").path(), "stages.0.fill");
    EXPECT_NO_THROW(config.finish());
}

struct Refused {
    const char* text;
    const char* message;
};

class Refusal : public ::testing::TestWithParam<Refused> {};

void read_all(const Config& config) {
    const auto cohesion = config.section("cohesion");
    (void)cohesion.number("bond_number", Range::not_negative());
    (void)cohesion.quantity_or("cut_off", Dimension::length, 1e-7, Range::positive());
    (void)cohesion.number_or("ratio", 0.5, {.lower = 0, .upper = 1, .lower_open = true});
    (void)cohesion.integer_or("count", 3, {.lower = 1});
    (void)cohesion.boolean_or("capped", true);
    (void)cohesion.choice_or("form", rolling_forms, "own");
    (void)cohesion.vector_or("box", Dimension::length, {});
    if (cohesion.has("hamaker") && !cohesion.has("bond_number")) (void)cohesion.quantity("hamaker", Dimension::energy);
    config.finish();
}

TEST_P(Refusal, IsOneSentenceWithPlaceAndAdvice) { EXPECT_EQ(refusal(GetParam().text, read_all), GetParam().message); }

INSTANTIATE_TEST_SUITE_P(
    Config, Refusal,
    ::testing::Values(
        Refused{"cohesion:\n  bond_number: 5\n  cutoff: 1 um\n",
                "scene.yaml:3: cohesion.cutoff: the key is unknown; did you mean \"cut_off\"?"},
        Refused{
            "cohesion:\n  bond_number: 5\n  zzz: 1 um\n",
            "scene.yaml:3: cohesion.zzz: the key is unknown; remove it or use one of bond_number, box, capped, count, "
            "cut_off, form, hamaker, ratio"},
        Refused{"cohesion:\n  bond_number: 5\n\n  hamaker: 1 aJ\n",
                "scene.yaml:4: cohesion.hamaker: the key has no effect beside the others that are given; remove it"},
        Refused{"cohesion:\n  bond_number: 5\nextra:\n  a: 1\n",
                "scene.yaml:3: extra: the key is unknown; remove it or use one of cohesion"},
        Refused{"cohesion:\n  cut_off: 1 um\n",
                "scene.yaml:1: cohesion.bond_number: the key is missing; give a plain number here"},
        Refused{"cohesoin:\n  cut_off: 1 um\n",
                "scene.yaml:1: cohesion: the key is missing; give a group of keys here (line 1 has \"cohesoin\": is it "
                "meant?)"},
        Refused{"cohesion: 5\n",
                "scene.yaml:1: cohesion: this is not a group of keys; write \"key: value\" lines below it"},
        Refused{"cohesion:\n  bond_number:\n",
                "scene.yaml:2: cohesion.bond_number: the key has no value; give a plain number"},
        Refused{"cohesion:\n  bond_number: [5]\n",
                "scene.yaml:2: cohesion.bond_number: this is a list; give a plain number"},
        Refused{"cohesion:\n  bond_number: five\n",
                "scene.yaml:2: cohesion.bond_number: \"five\" is not a plain number; write a number"},
        Refused{"cohesion:\n  bond_number: -5\n",
                "scene.yaml:2: cohesion.bond_number: -5 is out of range; it must be at least 0"},
        Refused{"cohesion: {bond_number: 5, ratio: 0}\n",
                "scene.yaml:1: cohesion.ratio: 0 is out of range; it must be greater than 0 and at most 1"},
        Refused{"cohesion: {bond_number: 5, cut_off: -1 nm}\n",
                "scene.yaml:1: cohesion.cut_off: -1 nm is out of range; it must be greater than 0 m"},
        Refused{"cohesion: {bond_number: 5, cut_off: 3}\n",
                "scene.yaml:1: cohesion.cut_off: \"3\" has no unit; a length is wanted: use one of m, cm, mm, um, nm"},
        Refused{"cohesion: {bond_number: 5, count: 1.5}\n",
                "scene.yaml:1: cohesion.count: \"1.5\" is not a whole number; write digits only, as in 2000"},
        Refused{"cohesion: {bond_number: 5, count: 0}\n",
                "scene.yaml:1: cohesion.count: 0 is out of range; it must be at least 1"},
        Refused{"cohesion: {bond_number: 5, capped: yes}\n",
                "scene.yaml:1: cohesion.capped: \"yes\" is not true or false; write one of these"},
        Refused{"cohesion: {bond_number: 5, form: mine}\n",
                "scene.yaml:1: cohesion.form: \"mine\" is not known; use one of own, relative"},
        Refused{"cohesion: {bond_number: 5, box: [1 m, 2 m]}\n",
                "scene.yaml:1: cohesion.box: the list has 2 values; give three components [x, y, z], each a length"},
        Refused{"cohesion:\n  bond_number: 5\n  box: 1\n  bond_number: 6\n",
                "scene.yaml:4: bond_number: the key was given before, on line 2; remove one of the two"},
        Refused{"cohesion:\n  bond_number: 5\n   ratio: 6\n",
                "scene.yaml:3: the text is not valid YAML (illegal map value); check the indentation, colons and "
                "quotes here"},
        Refused{"- a\n",
                "scene.yaml:1: the file holds no \"key: value\" pairs at its top; start from a shipped example"},
        Refused{"a: &a [*a]\n", "scene.yaml:1: the values are nested too deeply; simplify the file"}));

TEST(Config, TextInLatin1IsRead) {
    EXPECT_EQ(parse("length: 50 \xB5m\n").quantity("length", Dimension::length), 50e-6);
    EXPECT_EQ(parse("time: 2 \xC2\xB5s\n").quantity("time", Dimension::time), 2e-6);
}

TEST(Config, ErrorsNameTheOptionThatGaveAValue) {
    const std::vector<std::string> settings = {"x_range=[1, no]", "base=2"};
    const Config config = Config::parse("{}", "", settings);
    config.set_option("x_range", "--region 1,no");
    config.set_option("absent", "--nothing");
    EXPECT_EQ(message_of<InputError>([&] { config.fail("x_range", "too far; go back"); }),
              "--region 1,no: too far; go back");
    EXPECT_TRUE(message_of<InputError>([&] {
                    (void)config.quantities("x_range", Dimension::length);
                }).starts_with("--region 1,no: "));
    EXPECT_EQ(message_of<InputError>([&] { config.fail("base", "too low; go up"); }),
              "--set base=2: base: too low; go up");
}

TEST(Config, FailNamesTheKey) {
    EXPECT_EQ(
        refusal("a: 1\nb:\n  c: 2\n", [](const Config& c) { c.section("b").fail("c", "it is odd; take an even one"); }),
        "scene.yaml:3: b.c: it is odd; take an even one");
}

TEST(Config, OnlyTheKeysAllowedAreAllowed) {
    constexpr std::string_view keys[] = {"length", "width"};
    EXPECT_NO_THROW(Config::parse("width: 1\n", "scene.yaml").allow_only(keys));
    EXPECT_EQ(refusal("width: 1\nlenght: 2\n", [&](const Config& c) { c.allow_only(keys); }),
              "scene.yaml:2: lenght: the key is unknown; did you mean \"length\"?");
}

TEST(Config, FileThatCannotBeReadIsNamed) {
    const testing::TemporaryFolder folder;
    for (const auto& file : {folder / "absent.yaml", folder.path()}) {
        EXPECT_EQ(
            message_of<InputError>([&] { (void)Config::load(file); }).find(file.string() + ": the file cannot be read"),
            0U);
    }
    write_text_file(folder / "a.yaml", "a: 3\n");
    EXPECT_EQ(Config::load(folder / "a.yaml").integer("a"), 3);
}

}  // namespace
}  // namespace recoat
