#include <gtest/gtest.h>

#include "analyzer/configuration.hpp"
#include "analyzer/region.hpp"
#include "common/error.hpp"
#include "tests/support/throws_message.hpp"

namespace recoat {
namespace {

using testing::message_of;

const std::string complete =
    "d_p: 50 um\ndensity: 4430 kg/m3\nh_b: 1.5 dp\nx_range: [0, 1 mm]\ny_min: 0\ny_period: 12 dp\n";

AnalysisConfig read(const std::string& text, const SourceInfo& info = {}) {
    return read_analysis_config(Config::parse(text, "analysis.yaml"), info);
}

std::string error(const std::string& text, const SourceInfo& info = {}) {
    return message_of<InputError>([&] { (void)read(text, info); });
}

/// What a state of a layer says: 500 d_p of spreading from x = 2 mm.
SourceInfo state_info() {
    return {.particle_diameter = 50e-6,
            .density = 4430,
            .clearance = 75e-6,
            .y_min = -1e-3,
            .y_period = 2e-3,
            .blade_start = 2e-3,
            .spread_length = 25e-3};
}

TEST(AnalysisConfiguration, UnitsAndBareNumbersMeanTheSame) {
    const AnalysisConfig units = read(complete + "grid: 50 um\nphi_window: 3 dp\nz_bin: 5 um\nangle_bin: 10 deg\n");
    const AnalysisConfig bare = read(
        R"({"d_p": 5e-05, "density": 4430.0, "h_b": 7.5e-05, "x_range": [0.0, 0.001], "y_min": 0.0, "y_period": 0.0006,
            "grid": 1.0, "phi_window": 3.0, "z_bin": 0.1, "angle_bin": 10.0})");
    for (const AnalysisConfig& config : {units, bare}) {
        EXPECT_DOUBLE_EQ(config.particle_diameter, 5e-5);
        EXPECT_DOUBLE_EQ(config.clearance, 7.5e-5);
        EXPECT_DOUBLE_EQ(config.x_end, 1e-3);
        EXPECT_DOUBLE_EQ(config.y_period, 6e-4);
        EXPECT_DOUBLE_EQ(config.grid, 1);
        EXPECT_DOUBLE_EQ(config.z_bin, 0.1);
        EXPECT_NEAR(config.angle_bin, 10, 1e-12);
        EXPECT_EQ(config.voxels_per_dp, (std::vector<int>{10, 20}));
    }
}

TEST(AnalysisConfiguration, AStateStandsInForWhatIsLeftOut) {
    const AnalysisConfig config = read("voxels_per_dp: []\n", state_info());
    EXPECT_EQ(config.particle_diameter, 50e-6);
    EXPECT_EQ(config.density, 4430);
    EXPECT_EQ(config.clearance, 75e-6);
    EXPECT_EQ(config.y_min, -1e-3);
    EXPECT_EQ(config.y_period, 2e-3);
    EXPECT_NEAR(config.x_begin, 2e-3 + 100 * 50e-6, 1e-15);
    EXPECT_NEAR(config.x_end, 2e-3 + 490 * 50e-6, 1e-15);
    EXPECT_TRUE(config.voxels_per_dp.empty());
    EXPECT_EQ(read("h_b: 100 um\n", state_info()).clearance, 100e-6);
}

TEST(AnalysisConfiguration, TheRegionIsCutToWholeCells) {
    SourceInfo info = state_info();
    info.spread_length = 100.7 * 50e-6;
    const AnalysisConfig skipped = read("skip_start: 10 dp\nskip_end: 5 dp\n", info);
    EXPECT_NEAR(skipped.x_begin, 2e-3 + 10 * 50e-6, 1e-15);
    EXPECT_NEAR(skipped.x_end, 2e-3 + 95 * 50e-6, 1e-15);
    const AnalysisConfig usual = read("{}", info);  // from 20.14 to 98.686 d_p
    EXPECT_NEAR((usual.x_end - usual.x_begin) / 50e-6, 78, 1e-9);
    EXPECT_EQ(error("skip_start: 90 dp\nskip_end: 11 dp\n", info),
              "analysis.yaml:1: skip_start: nothing is left of the spreading length; skip less, or give x_range");
}

TEST(AnalysisConfiguration, MissingKeysAreNamed) {
    EXPECT_NE(error("density: 4430\n").find("d_p: the key is missing"), std::string::npos);
    EXPECT_NE(
        error("d_p: 50 um\ndensity: 4430\nh_b: 75 um\ny_min: 0\ny_period: 1 mm\n").find("x_range: the key is missing"),
        std::string::npos);
}

TEST(AnalysisConfiguration, WhatDoesNotFitTogetherIsRefused) {
    EXPECT_NE(error(complete + "gird: 1\n").find("grid"), std::string::npos);
    EXPECT_EQ(
        error(complete + "grid: 3\n"),
        "analysis.yaml:4: x_range: the region is 6.66667 cells of 0.00015 m long; make it a whole number of cells");
    EXPECT_NE(error(complete + "grid: 2.5\n").find("y_period: the period is 4.8 cells"), std::string::npos);
    EXPECT_NE(error(complete + "phi_window: 13\n").find("phi_window: the window is wider than the y period"),
              std::string::npos);
    const std::string short_region =
        "d_p: 1\ndensity: 1\nh_b: 1\nx_range: [0, 4]\ny_min: 0\ny_period: 8\nphi_x_edge: interior\n";
    EXPECT_NE(error(short_region + "phi_window: 4\n").find("phi_x_edge: no window lies in the region"),
              std::string::npos);
    EXPECT_EQ(read(short_region + "phi_window: 3\n").phi_window, 3);
    EXPECT_NE(error(complete + "voxels_per_dp: [2.5]\n").find("voxels_per_dp: 2.5 is no whole number"),
              std::string::npos);
    EXPECT_NE(error(complete + "voxels_per_dp: [0]\n").find("voxels_per_dp"), std::string::npos);
    EXPECT_NE(
        error(complete + "voxels_per_dp: [5]\nheight_window: 0.5\n").find("height_window is 2.5 voxels at 5 per d_p"),
        std::string::npos);
    EXPECT_NE(error(complete + "skip_start: 1 dp\n").find("skip_start: x_range is given too"), std::string::npos);
    EXPECT_NE(error(complete + "contact_mode: sum\n").find("contact_mode"), std::string::npos);
    EXPECT_NE(error(complete + "z_bin: -1 um\n").find("z_bin: -0.02 d_p is out of range"), std::string::npos);
    EXPECT_NE(error(complete + "h_b: 1 dp\n").find("h_b"), std::string::npos);  // twice
}

/// What a file of another code says, with particles between x = 0 and 2 mm.
SourceInfo foreign_info(double particle_diameter) {
    return {.particle_diameter = particle_diameter, .y_min = 0, .y_period = 7e-4, .x_lower = 0, .x_upper = 2e-3};
}

TEST(AnalysisConfiguration, AnyPeriodWillDoUntilAGridIsNamed) {
    const std::string least = "density: 4430\nh_b: 75 um\n";
    for (const double diameter : {68e-6, 37.3e-6, 90.7e-6}) {
        const AnalysisConfig config = read(least, foreign_info(diameter));
        EXPECT_EQ(config.grid, 1);
        EXPECT_NEAR(config.x_begin, diameter, 1e-15);
        EXPECT_LE(config.x_end, 2e-3 - diameter + 1e-12);
        EXPECT_GT(config.x_end, 2e-3 - 2 * diameter);
        const AnalysisConfig asked = read(least + "x_range: [0, 1.9 mm]\n", foreign_info(diameter));
        EXPECT_EQ(asked.x_end, 1.9e-3);
        EXPECT_NE(error(least + "grid: 1 dp\n", foreign_info(diameter)).find("y_period: the period is"),
                  std::string::npos);
        EXPECT_NE(error(least + "grid: 50 um\nx_range: [0, 1.98 mm]\n", foreign_info(diameter))
                      .find("x_range: the region is 39.6 cells of 5e-05 m long"),
                  std::string::npos);
        EXPECT_NO_THROW((void)read(least + "grid: 50 um\n", foreign_info(diameter)));
    }
}

TEST(AnalysisConfiguration, WindowsAreSizedForThePeriod) {
    const std::string least = "density: 4430\nh_b: 75 um\n";
    SourceInfo info = foreign_info(50e-6);
    info.y_period = 60e-6;
    EXPECT_NE(error(least, info)
                  .find("phi_window: the window is wider than the y period: 3 d_p in a period of 1.2 d_p; "
                        "take a smaller one, e.g. --set phi_window=1dp"),
              std::string::npos);
    EXPECT_NO_THROW((void)read(least + "phi_window: 1 dp\n", info));
    // 2.2 voxels of the default resolutions do not matter; they do where they are asked for.
    EXPECT_NO_THROW((void)read(least + "phi_window: 0.22 dp\n", info));
    EXPECT_NE(error(least + "phi_window: 0.22 dp\nvoxels_per_dp: [10]\n", info).find("phi_window is 2.2 voxels"),
              std::string::npos);
    EXPECT_NE(error(least + "phi_window: 0.05 dp\n", info).find("phi_window is less than one voxel at 10 per d_p"),
              std::string::npos);
}

TEST(AnalysisConfiguration, ARegionGoesNoFartherThanAFewWindowsBeyondTheParticles) {
    const std::string least = "density: 4430\nh_b: 75 um\n";
    const auto check = [&](const std::string& range, const SourceInfo& info) {
        const Config config = Config::parse(least + "x_range: [" + range + "]\n", "analysis.yaml");
        const AnalysisConfig resolved = read_analysis_config(config, info);
        check_reach(config, info, {resolved.x_begin, resolved.x_end}, 3 * resolved.particle_diameter);
    };
    const auto refusal = [&](const std::string& range, const SourceInfo& info) {
        return message_of<InputError>([&] { check(range, info); });
    };
    const SourceInfo info = foreign_info(50e-6);
    EXPECT_NO_THROW(check("-0.75 mm, 2.75 mm", info));
    EXPECT_EQ(refusal("-1 mm, 2 mm", info),
              "analysis.yaml:3: x_range: the region x = -0.001 ... 0.002 m reaches 0.001 m beyond the particles, which "
              "lie between x = 0 and 0.002 m; give one that reaches no more than 0.00075 m beyond them");
    EXPECT_NE(refusal("0, 2 m", info).find("reaches 2 m beyond the particles"), std::string::npos);
    EXPECT_EQ(
        refusal("1 m, 2 m", info),
        "analysis.yaml:3: x_range: no particle lies in the region x = 1 ... 2 m; they lie between x = 0 and 0.002 "
        "m: give a region there");
    EXPECT_NE(refusal("-1 m, -0.1 m", info).find("no particle lies in the region"), std::string::npos);
    EXPECT_NE(refusal("1 mm, 0", info).find("the region ends before it begins"), std::string::npos);
    // Where the blade has been, an empty base is a result.
    SourceInfo bare = state_info();
    bare.x_lower = 2.1e-3;
    bare.x_upper = 2.5e-3;
    EXPECT_NO_THROW(check("5 mm, 25 mm", bare));
    EXPECT_NE(refusal("5 mm, 30 mm", bare).find("reaches 0.003 m beyond the particles"), std::string::npos);
}

TEST(AnalysisConfiguration, ContactsGoByTheRadiiUnlessToldOtherwise) {
    EXPECT_EQ(read(complete).contact_mode, ContactMode::radii);
    EXPECT_EQ(read(complete + "contact_mode: dp\n").contact_mode, ContactMode::particle_diameter);
}

TEST(AnalysisConfiguration, ColumnNames) {
    const Config config = Config::parse("columns: {x: px, diameter: size}\n", "analysis.yaml");
    EXPECT_EQ(read_column_names(config).x, "px");
    EXPECT_EQ(read_column_names(config).diameter, "size");
    EXPECT_EQ(read_column_names(config).radius, "");
    const Config both = Config::parse("columns: {radius: r1, diameter: d1}\n", "analysis.yaml");
    EXPECT_NE(message_of<InputError>([&] {
                  (void)read_column_names(both);
              }).find("columns.diameter: a radius column is named too"),
              std::string::npos);
}

}  // namespace
}  // namespace recoat
