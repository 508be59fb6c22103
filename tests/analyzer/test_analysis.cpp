#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "analyzer/analysis.hpp"
#include "analyzer/output/json_report.hpp"
#include "analyzer/readers/reader.hpp"
#include "common/error.hpp"
#include "common/state.hpp"
#include "tests/analyzer/support.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/throws_message.hpp"

namespace recoat {
namespace {

using testing::layer_of;
using testing::message_of;
using testing::random_balls;
using testing::unit_config;

std::string report_with_threads(std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const AnalysisConfig config = unit_config(40, 12);
    return json_report(analyse(layer_of(random_balls(900, 40, 12, 2), config), config), config).dump();
}

TEST(Analysis, DoesNotDependOnTheNumberOfThreads) {
    const std::string one = report_with_threads(1);
    for (int repeat = 0; repeat < 3; ++repeat) {
        EXPECT_EQ(report_with_threads(2), one);
        EXPECT_EQ(report_with_threads(4), one);
    }
}

TEST(Analysis, DoesNotChangeWhenTheLayerIsMovedByWholeCells) {
    AnalysisConfig config = unit_config(8, 6);
    const auto balls = random_balls(80, 8, 6, 9);
    const Analysis here = analyse(layer_of(balls, config), config);
    auto moved = balls;
    for (auto& ball : moved) {
        ball.x += 4;
        ball.y += 2;
    }
    config.x_begin = 4;
    config.x_end = 12;
    const Analysis there = analyse(layer_of(moved, config), config);
    ASSERT_EQ(here.packing.exact.values.size(), there.packing.exact.values.size());
    for (int ix = 0; ix < 8; ++ix) {
        for (int iy = 0; iy < 6; ++iy) {
            EXPECT_NEAR(there.packing.exact.at(ix, (iy + 2) % 6), here.packing.exact.at(ix, iy), 1e-13);
            EXPECT_NEAR(there.height_map.at(ix, (iy + 2) % 6), here.height_map.at(ix, iy), 1e-7);
        }
    }
    EXPECT_EQ(there.coordination.cn_counts, here.coordination.cn_counts);
    EXPECT_EQ(there.cluster_sizes.size_fraction, here.cluster_sizes.size_fraction);
    EXPECT_NEAR(there.totals.layer_phi, here.totals.layer_phi, 1e-13);
}

TEST(Analysis, AFileOnceCroppedAndTheSameCroppedHereAgree) {
    AnalysisConfig config = unit_config(8, 6);
    const auto balls = random_balls(80, 8, 6, 9);
    std::vector<testing::Ball> inside;
    std::ranges::copy_if(balls, std::back_inserter(inside), [](const auto& ball) { return ball.x >= 0 && ball.x < 8; });
    const auto whole = json_report(analyse(layer_of(inside, config), config), config);
    config.crop_first = true;
    auto cropped = json_report(analyse(layer_of(balls, config), config), config);
    EXPECT_TRUE(cropped["config"]["crop_first"]);
    cropped["config"]["crop_first"] = false;
    EXPECT_EQ(cropped, whole);
}

TEST(Analysis, ReadsAStateWithWhatItSays) {
    const testing::TemporaryFolder folder;
    const auto file = folder / "layer.vtkhdf";
    StateInfo info;
    info.diameter = 50e-6;
    info.density = 4430;
    info.clearance = 75e-6;
    info.y_min = 0;
    info.y_period = 200e-6;
    info.blade_start = 1e-3;
    info.spread_length = 1e-3;
    State state;
    state.id = {0, 1};
    state.position = {{1.3e-3, 0, 25e-6}, {1.35e-3, 0, 25e-6}};
    state.velocity.resize(2);
    state.angular_velocity.resize(2);
    state.radius = {25e-6, 25e-6};
    write_state(file, info, state);

    const Source source = read_particles(file);
    EXPECT_EQ(source.format, "recoat-state");
    EXPECT_EQ(source.position[1], state.position[1]);
    const AnalysisConfig config = read_analysis_config(Config::parse("{}", "analysis.yaml"), source.info);
    EXPECT_NEAR(config.x_begin, 1.2e-3, 1e-12);
    EXPECT_NEAR(config.x_end, 1.95e-3, 1e-12);  // 0.98 mm of the way would be 15.6 cells
    const Analysis analysis = analyse(make_layer(source, config), config);
    EXPECT_EQ(analysis.coordination.n_particles, 2U);
    EXPECT_EQ(analysis.coordination.n_contacts, 1U);

    state.radius[1] = -1;
    write_state(file, info, state);
    EXPECT_NE(message_of<InputError>([&] { (void)read_particles(file); }).find("particle 1 has the centre"),
              std::string::npos);
}

TEST(Analysis, RefusesMistakenUnits) {
    AnalysisConfig config = unit_config(4e-6, 4e-6);
    config.particle_diameter = 1e-6;
    EXPECT_NE(message_of<InputError>([&] {
                  (void)layer_of({{2, 2}}, config);
              }).find("check the unit"),
              std::string::npos);
}

}  // namespace
}  // namespace recoat
