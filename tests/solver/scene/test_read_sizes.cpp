#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/error.hpp"
#include "solver/scene/derived.hpp"
#include "solver/scene/time_step_limits.hpp"
#include "tests/support/scene_text.hpp"
#include "tests/support/throws_message.hpp"

namespace recoat {
namespace {

using ::testing::HasSubstr;

Scene scene_with(const std::string& sizes, std::vector<std::string> settings = {}) {
    std::string text = testing::spread_text;
    text.replace(text.find("powder: {particles: 40}"), 23, "powder: {particles: 40, sizes: {" + sizes + "}}");
    settings.insert(settings.begin(), "box.width=7 dp");
    return testing::scene_of(text, settings);
}

const SizeDistribution& sizes_of(const Scene& scene) { return *std::get<ColumnSource>(scene.source).sizes; }

std::string refusal(const std::string& sizes, const std::vector<std::string>& settings = {}) {
    return testing::message_of<InputError>([&] { scene_with(sizes, settings); });
}

const std::string log_normal =
    "distribution: log_normal, median: 1 dp, geometric_deviation: 1.3, smallest: 30 um, largest: 80 um";

TEST(ReadSizes, EachDistributionIsThatOfItsNumbers) {
    EXPECT_EQ(sizes_of(scene_with(log_normal)),
              SizeDistribution::log_normal(50e-6, 1.3, 30e-6, 80e-6, Weighting::number));
    EXPECT_EQ(sizes_of(scene_with("distribution: normal, mean: 50 um, standard_deviation: 0.1 dp, smallest: 30 um, "
                                  "largest: 80 um, weighting: mass")),
              SizeDistribution::normal(50e-6, 5e-6, 30e-6, 80e-6, Weighting::mass));
    EXPECT_EQ(sizes_of(scene_with("distribution: table, diameters: [30 um, 50 um, 60 um], cumulative: [0, 0.3, 1]")),
              SizeDistribution::table({30e-6, 50e-6, 60e-6}, {0, 0.3, 1}, Weighting::number));
}

TEST(ReadSizes, TheResolvedSceneReadsBackAsTheSame) {
    const Scene scene = scene_with(log_normal);
    EXPECT_THAT(scene.resolved, HasSubstr("weighting: number"));
    EXPECT_EQ(sizes_of(testing::scene_of(scene.resolved)), sizes_of(scene));
}

TEST(ReadSizes, WithoutThemAllHaveOneDiameter) {
    const Scene scene = testing::scene_of(testing::spread_text);
    EXPECT_FALSE(std::get<ColumnSource>(scene.source).sizes);
    EXPECT_FALSE(powder_sizes(scene));
    EXPECT_EQ(scene.smallest_diameter, scene.diameter);
    EXPECT_EQ(scene.largest_diameter, scene.diameter);
}

TEST(ReadSizes, SaysWhatIsWrong) {
    EXPECT_THAT(refusal("distribution: uniform"), HasSubstr("powder.sizes.distribution"));
    EXPECT_THAT(refusal("distribution: normal, mean: 50 um"), HasSubstr("standard_deviation"));
    EXPECT_THAT(refusal(log_normal + ", mean: 3 um"), HasSubstr("powder.sizes.mean"));
    EXPECT_THAT(
        refusal("distribution: log_normal, median: 50 um, geometric_deviation: 1, smallest: 1 um, largest: 2 um"),
        HasSubstr("geometric_deviation"));
    EXPECT_THAT(
        refusal("distribution: log_normal, median: 50 um, geometric_deviation: 1.3, smallest: 80 um, largest: 80 um"),
        HasSubstr("largest diameter does not exceed"));
    EXPECT_THAT(
        refusal("distribution: log_normal, median: 50 um, geometric_deviation: 1.1, smallest: 80 um, largest: 90 um"),
        HasSubstr("less than a thousandth"));
    const std::string table = "distribution: table, diameters: ";
    EXPECT_THAT(refusal(table + "[30 um, 50 um], cumulative: [0, 0.5, 1]"), HasSubstr("as many shares"));
    EXPECT_THAT(refusal(table + "[50 um, 30 um], cumulative: [0, 1]"), HasSubstr("do not rise"));
    EXPECT_THAT(refusal(table + "[30 um, 30 um], cumulative: [0, 1]"), HasSubstr("do not rise"));
    EXPECT_THAT(refusal(table + "[30 um, 50 um], cumulative: [0.1, 1]"), HasSubstr("from 0 to 1"));
    EXPECT_THAT(refusal(table + "[30 um, 40 um, 50 um], cumulative: [0, 1, 0.5]"), HasSubstr("from 0 to 1"));
}

TEST(ReadSizes, TheBoxMustHoldTheLargestAndTheAttractionTheSmallest) {
    EXPECT_THAT(refusal(log_normal, {"box.width=6 dp"}), HasSubstr("6.4 dp"));
    EXPECT_THAT(refusal(log_normal, {"box.fill_length=3 dp"}), HasSubstr("3.2 dp"));
    EXPECT_THAT(refusal(log_normal, {"cohesion.bond_number=1", "cohesion.cut_off=4 um"}),
                HasSubstr("smallest diameter"));
}

// Half the diameter: the Rayleigh time is half; S_n/m* at the same speed grows as R^(-2) [docs/physics.md 4.1].
TEST(ReadSizes, TheTimeStepIsThatOfTheSmallest) {
    const std::string table = "distribution: table, diameters: [25 um, 50 um], cumulative: [0, 1]";
    const std::vector<StepLimit> of_all = time_step_limits(testing::scene_of(testing::spread_text));
    const std::vector<StepLimit> of_smallest = time_step_limits(scene_with(table));
    ASSERT_EQ(of_all.size(), of_smallest.size());
    for (std::size_t k = 0; k < of_all.size(); ++k)
        EXPECT_NEAR(of_smallest[k].limit / of_all[k].limit, 0.5, 1e-9) << of_all[k].name;
    const double between = 0.75 * of_all[3].limit;
    EXPECT_THAT(refusal(table, {"time_step=" + std::to_string(1e9 * between) + " ns"}), HasSubstr("stability limit"));
}

// Attraction grows as d, weight as d^3.
TEST(ReadSizes, TheBondNumberFallsWithTheSquareOfTheDiameter) {
    const PowderSizes sizes = *powder_sizes(scene_with(log_normal, {"cohesion.bond_number=10"}));
    EXPECT_NEAR(sizes.bond_smallest, 10 * 25.0 / 9, 1e-9);
    EXPECT_NEAR(sizes.bond_largest, 10 * 25.0 / 64, 1e-9);
    EXPECT_EQ(sizes.smallest, 30e-6);
    EXPECT_LT(sizes.median_by_number, sizes.median_by_mass);
}

}  // namespace
}  // namespace recoat
