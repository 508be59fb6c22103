#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/error.hpp"
#include "common/output_file.hpp"
#include "common/state.hpp"
#include "solver/run.hpp"
#include "tests/support/fake_engine.hpp"
#include "tests/support/scene_text.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/throws_message.hpp"

namespace recoat {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class RunFolder : public ::testing::Test {
protected:
    int run(const std::string& setting = "seed=1", std::optional<std::int64_t> until = {}, bool overwrite = false) {
        const Scene scene = testing::scene_of(testing::spread_text, {"time_step=1e-6 s", setting});
        return run_scene(scene, {folder_ / "a", {Backend::cpu, 1, 0}, true, overwrite, until},
                         testing::fake_factory(script_));
    }
    int resume() {
        return resume_run({folder_ / "a", {Backend::cpu, 1, 0}, true, false, {}}, testing::fake_factory(script_));
    }

    testing::TemporaryFolder folder_;
    testing::FakeScript script_;
};

TEST_F(RunFolder, AFinishedRunIsLeftAsItIs) {
    run();
    const auto time = fs::last_write_time(folder_ / "a/spread.vtkhdf");
    EXPECT_EQ(run(), 0);
    EXPECT_EQ(resume(), 0);
    EXPECT_EQ(script_.made, 1);
    EXPECT_EQ(script_.restored, 0);
    EXPECT_EQ(fs::last_write_time(folder_ / "a/spread.vtkhdf"), time);
}

TEST_F(RunFolder, AFinishedRunThatLacksAFileIsRunAgain) {
    run();
    fs::remove(folder_ / "a/heap.vtkhdf");
    EXPECT_EQ(run(), 0);
    EXPECT_EQ(script_.made, 2);
    EXPECT_TRUE(fs::exists(folder_ / "a/heap.vtkhdf"));
}

std::string bytes(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

// The checkpoint is of the end of the last stage.
TEST_F(RunFolder, TheLastStateIsMadeAgainFromTheCheckpoint) {
    run();
    const State state = read_state(folder_ / "a/spread.vtkhdf");
    const std::string energy = bytes(folder_ / "a/energy.csv");
    for (const bool resumed : {true, false}) {
        fs::remove(folder_ / "a/spread.vtkhdf");
        fs::remove(folder_ / "a/energy.csv");
        EXPECT_EQ(resumed ? resume() : run(), 0);
        EXPECT_EQ(script_.made, 1);
        EXPECT_EQ(read_state(folder_ / "a/spread.vtkhdf").position, state.position);
        EXPECT_EQ(read_state(folder_ / "a/spread.vtkhdf").step, state.step);
        EXPECT_EQ(bytes(folder_ / "a/energy.csv"), energy);
    }
}

TEST_F(RunFolder, WhatCannotBeMadeAgainIsSaid) {
    run("output.trajectory_interval=10 ms");
    fs::remove(folder_ / "a/heap.vtkhdf");
    EXPECT_THAT(testing::message_of<InputError>([&] { resume(); }), HasSubstr("heap.vtkhdf is gone"));
    run("output.trajectory_interval=10 ms");
    fs::remove(folder_ / "a/trajectory.vtkhdf");
    EXPECT_THAT(testing::message_of<InputError>([&] { resume(); }),
                HasSubstr("trajectory.frames/000000.vtkhdf and 5 more are gone"));
}

// Whoever moved the state of an early stage away can still continue; the trajectory could not be joined in the end.
TEST_F(RunFolder, AnUnfinishedRunGoesOnWithoutAnEarlyStateButNotWithoutItsTrajectory) {
    run("output.trajectory_interval=10 ms", 40000);
    fs::remove(folder_ / "a/fill.vtkhdf");
    EXPECT_EQ(resume(), 0);
    EXPECT_TRUE(fs::exists(folder_ / "a/spread.vtkhdf"));
    run("output.trajectory_interval=10 ms", 40000);
    fs::remove(folder_ / "a/trajectory.frames/000001.vtkhdf");
    EXPECT_THAT(testing::message_of<InputError>([&] { resume(); }),
                HasSubstr("trajectory.frames/000001.vtkhdf is gone"));
}

TEST_F(RunFolder, AFinishedRunNeedsNoCheckpoint) {
    run();
    fs::remove(folder_ / "a/checkpoint.h5");
    fs::remove(folder_ / "a/checkpoint-previous.h5");
    EXPECT_EQ(resume(), 0);
    EXPECT_EQ(script_.restored, 0);
}

TEST_F(RunFolder, AnUnfinishedRunIsContinued) {
    run("seed=1", 20000);
    EXPECT_EQ(run(), 0);
    EXPECT_EQ(script_.made, 1);
    EXPECT_EQ(script_.restored, 1);
}

TEST_F(RunFolder, AnotherConfigurationIsRefusedUnlessOverwritten) {
    run();
    EXPECT_THAT(testing::message_of<InputError>([&] { run("seed=2"); }),
                HasSubstr("another configuration (seed is 1 there and 2 here)"));
    EXPECT_EQ(run("seed=2", {}, true), 0);
    EXPECT_EQ(script_.made, 2);
}

TEST_F(RunFolder, OverwritingKeepsOrContinuesARunOfTheSameConfiguration) {
    run("seed=1", 20000, true);
    EXPECT_EQ(run("seed=1", {}, true), 0);
    EXPECT_EQ(run("seed=1", {}, true), 0);
    EXPECT_EQ(script_.made, 1);
    EXPECT_EQ(script_.restored, 1);
}

TEST_F(RunFolder, AnUnfinishedRunOfAnotherConfigurationIsRefusedToo) {
    run("seed=1", 20000);
    fs::remove(folder_ / "a/summary.json");
    EXPECT_THAT(testing::message_of<InputError>([&] { run("seed=2"); }), HasSubstr("another configuration"));
}

TEST_F(RunFolder, StartingAnewRemovesOldResults) {
    run();
    run("seed=2", 5000, true);
    EXPECT_FALSE(fs::exists(folder_ / "a/fill.vtkhdf"));
    EXPECT_FALSE(fs::exists(folder_ / "a/spread.vtkhdf"));
}

TEST_F(RunFolder, NothingToResume) {
    EXPECT_THAT(testing::message_of<InputError>([&] { resume(); }), HasSubstr("no checkpoint"));
}

// Killed between the last checkpoint and the summary.
TEST_F(RunFolder, AFinishedRunWithoutItsSummaryOnlyWritesIt) {
    run();
    fs::remove(folder_ / "a/summary.json");
    EXPECT_EQ(run(), 0);
    EXPECT_EQ(script_.made, 1);
    EXPECT_TRUE(fs::exists(folder_ / "a/summary.json"));
    fs::remove(folder_ / "a/summary.json");
    fs::remove(folder_ / "a/heap.vtkhdf");
    EXPECT_EQ(run(), 0);
    EXPECT_EQ(script_.made, 2);
}

TEST_F(RunFolder, ADamagedCheckpointIsRefusedUnlessOverwritten) {
    run("seed=1", 20000);
    fs::remove(folder_ / "a/checkpoint-previous.h5");
    fs::remove(folder_ / "a/summary.json");
    fs::resize_file(folder_ / "a/checkpoint.h5", 3000);
    EXPECT_THAT(testing::message_of<InputError>([&] { run(); }), HasSubstr("damaged"));
    EXPECT_THAT(testing::message_of<InputError>([&] { resume(); }), HasSubstr("damaged"));
    EXPECT_EQ(run("seed=1", {}, true), 0);
    EXPECT_EQ(script_.made, 2);
}

TEST_F(RunFolder, TheEarlierCheckpointIsTakenForADamagedOne) {
    run("seed=1", 15000);
    run("seed=1", 20000);
    fs::resize_file(folder_ / "a/checkpoint.h5", 3000);
    EXPECT_EQ(resume(), 0);
    EXPECT_EQ(script_.made, 1);
    EXPECT_EQ(script_.restored, 2);
}

TEST_F(RunFolder, LeftoversOfAKilledRunGo) {
    run("seed=1", 15000);
    write_text_file(folder_ / "a/.checkpoint.h5.77.part", "half");
    EXPECT_EQ(run(), 0);
    EXPECT_FALSE(fs::exists(folder_ / "a/.checkpoint.h5.77.part"));
}

// A fault whose state cannot be written is a fault still.
TEST_F(RunFolder, AFaultIsToldWhenItsStateCannotBeWritten) {
    run("seed=1", 3000);
    script_.fault_at = 5000;
    fs::create_directories(folder_ / "a/fault.vtkhdf/full");
    const std::string sentence = testing::message_of<SimulationFault>([&] { resume(); });
    EXPECT_THAT(sentence, HasSubstr("particle 3"));
    EXPECT_THAT(sentence, HasSubstr("is lost"));
}

TEST_F(RunFolder, WhatCannotBeRemovedIsNamed) {
    fs::create_directories(folder_ / "a/fault.vtkhdf/full");
    EXPECT_THAT(testing::message_of<InputError>([&] { run(); }), HasSubstr("fault.vtkhdf"));
}

TEST_F(RunFolder, AFileInPlaceOfTheFolderIsRefused) {
    write_text_file(folder_ / "a", "text");
    EXPECT_THAT(testing::message_of<InputError>([&] { run(); }), HasSubstr("cannot be made"));
}

}  // namespace
}  // namespace recoat
