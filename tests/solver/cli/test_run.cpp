#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "common/error.hpp"
#include "common/state.hpp"
#include "solver/run.hpp"
#include "tests/support/fake_engine.hpp"
#include "tests/support/scene_text.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/throws_message.hpp"

namespace recoat {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

// Steps of 1 us: fill 10 000 at most, heap 20 000, lift 1500, travel 20 000, settle 5000.
const std::vector<std::string> coarse = {"time_step=1e-6 s", "output.energy_interval=1 ms",
                                         "output.trajectory_interval=10 ms"};

class Run : public ::testing::Test {
protected:
    int run(const fs::path& folder, std::optional<std::int64_t> until = {}) {
        return run_scene(scene_, options(folder, until), testing::fake_factory(script_));
    }
    int resume(const fs::path& folder, std::optional<std::int64_t> until = {}) {
        return resume_run(options(folder, until), testing::fake_factory(script_));
    }
    static RunOptions options(const fs::path& folder, std::optional<std::int64_t> until) {
        RunOptions result;
        result.folder = folder;
        result.quiet = true;
        result.until_step = until;
        return result;
    }
    static nlohmann::json summary(const fs::path& folder) {
        std::ifstream file(folder / "summary.json");
        return nlohmann::json::parse(file);
    }
    static std::string bytes(const fs::path& file) {
        std::ifstream stream(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    static nlohmann::json without_clock(nlohmann::json json) {
        json.erase("wall_seconds");
        for (auto& stage : json["stages"]) {
            stage.erase("wall_seconds");
            stage.erase("particle_steps_per_second");
        }
        return json;
    }

    testing::TemporaryFolder folder_;
    testing::FakeScript script_;
    Scene scene_ = testing::scene_of(testing::spread_text, coarse);
};

TEST_F(Run, GoesThroughTheStagesInOrder) {
    EXPECT_EQ(run(folder_ / "a"), 0);
    EXPECT_THAT(script_.log, ElementsAre("10000: gate removed", "30000: blade moves", "31500: blade stops",
                                         "31500: blade moves", "51500: blade stops"));
    EXPECT_EQ(read_state(folder_ / "a/fill.vtkhdf").step, 10000);
    EXPECT_EQ(read_state(folder_ / "a/heap.vtkhdf").step, 30000);
    EXPECT_EQ(read_state(folder_ / "a/spread.vtkhdf").step, 56500);
    const nlohmann::json json = summary(folder_ / "a");
    EXPECT_EQ(json["status"], "finished");
    ASSERT_EQ(json["stages"].size(), 3U);
    EXPECT_EQ(json["stages"][2]["steps"], 26500);
    EXPECT_EQ(json["stages"][0]["settled"], false);
    EXPECT_TRUE(json["stages"][0].contains("packing_density"));
    EXPECT_FALSE(json["stages"][1].contains("packing_density"));
    EXPECT_NEAR(json["energy"]["balance_error"].get<double>(), 0, 1e-20);
}

TEST_F(Run, EndsAStageWhenItHasBeenAtRestLongEnough) {
    const RestCriterion rest = *scene_.stages[0].segments[0].rest;
    const double limit = rest.energy * 40;
    // calm from step 2000 on, but for one stir that must start the count anew
    const std::int64_t stir = rest.interval * ((2000 + 4 * rest.interval) / rest.interval);
    script_.kinetic_energy = [=](std::int64_t step) { return step < 2000 || step == stir ? 2 * limit : 0.5 * limit; };
    run(folder_ / "a");
    const nlohmann::json json = summary(folder_ / "a");
    EXPECT_EQ(json["stages"][0]["settled"], true);
    EXPECT_EQ(json["stages"][0]["steps"], stir + 10 * rest.interval);
    EXPECT_EQ(json["stages"][1]["steps"], 10 * rest.interval);
}

TEST_F(Run, LeavesOutAsManyStragglersAsTheStageSays) {
    script_.kinetic_energy = [](std::int64_t) { return 0.0; };
    for (Stage& stage : scene_.stages) stage.segments.back().rest->stragglers = std::nullopt;
    run(folder_ / "a");
    EXPECT_EQ(script_.rest.stragglers, 1u) << "a quarter of the root of 40";
    for (Stage& stage : scene_.stages) stage.segments.back().rest->stragglers = 3;
    run(folder_ / "b");
    EXPECT_EQ(script_.rest.stragglers, 3u);
    // The blade has gone 20 d_p and is 4 d_p thick.
    EXPECT_NEAR(script_.rest.front, 24 * scene_.diameter, 1e-9);
}

TEST_F(Run, WritesTrajectoryAndEnergySeriesAtTheirIntervals) {
    run(folder_ / "a");
    EXPECT_EQ(count_steps(folder_ / "a/trajectory.vtkhdf"), 6U);
    EXPECT_EQ(read_state(folder_ / "a/trajectory.vtkhdf", 3).step, 30000);
    const std::string energy = bytes(folder_ / "a/energy.csv");
    EXPECT_EQ(std::ranges::count(energy, '\n'), 1 + 57);
}

// The fake engine restores exactly what it saved; so any difference would be the driver's.
TEST_F(Run, StoppedAnywhereAndResumedItIsTheSameRun) {
    run(folder_ / "whole");
    for (std::int64_t stop : {0, 1, 10000, 10001, 31500, 40000, 56499}) {
        const fs::path part = folder_ / ("part" + std::to_string(stop));
        EXPECT_EQ(run(part, stop), 0);
        EXPECT_EQ(summary(part)["status"], "stopped");
        EXPECT_EQ(summary(part)["steps"], stop);
        EXPECT_EQ(resume(part), 0);
        EXPECT_EQ(without_clock(summary(part)), without_clock(summary(folder_ / "whole"))) << stop;
        EXPECT_EQ(bytes(part / "energy.csv"), bytes(folder_ / "whole/energy.csv")) << stop;
        EXPECT_EQ(count_steps(part / "trajectory.vtkhdf"), 6U);
        EXPECT_EQ(read_state(part / "spread.vtkhdf").position, read_state(folder_ / "whole/spread.vtkhdf").position);
    }
}

TEST_F(Run, ResumesAsOftenAsItIsStopped) {
    run(folder_ / "whole");
    run(folder_ / "part", 5000);
    resume(folder_ / "part", 20000);
    resume(folder_ / "part", 45000);
    resume(folder_ / "part");
    EXPECT_EQ(without_clock(summary(folder_ / "part")), without_clock(summary(folder_ / "whole")));
}

TEST_F(Run, AFaultLeavesTheMomentBeforeAndSaysWhere) {
    script_.fault_at = 12345;
    const std::string message = testing::message_of<SimulationFault>([&] { run(folder_ / "a"); });
    EXPECT_THAT(message, HasSubstr("particle 3"));
    EXPECT_THAT(message, HasSubstr("fault.vtkhdf"));
    EXPECT_EQ(read_state(folder_ / "a/fault.vtkhdf").step, 12345);
    EXPECT_EQ(read_state_info(folder_ / "a/fault.vtkhdf").stage, "heap");
    EXPECT_FALSE(fs::exists(folder_ / "a/summary.json"));
}

}  // namespace
}  // namespace recoat
