#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/error.hpp"
#include "common/output_file.hpp"
#include "solver/output/checkpoint.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/throws_message.hpp"

namespace recoat {
namespace {

using ::testing::HasSubstr;

Checkpoint sample() {
    Checkpoint checkpoint;
    checkpoint.version = "1.2";
    checkpoint.config = "scene: spread\nname: \"µ\"\n";
    RunProgress& progress = checkpoint.progress;
    progress.stage = 2;
    progress.segment = 1;
    progress.segment_entered = true;
    progress.segment_steps = 1234567890123;
    progress.checks_at_rest = 7;
    progress.settled = true;
    progress.stage_first_step = 99;
    progress.frames = 12;
    progress.wall_seconds = 0.1;
    progress.stage_wall_seconds = 1.0 / 3;
    progress.start.gravity = 1e-300;
    progress.start.cohesion = -0.0;
    StageRecord record;
    record.name = "fill";
    record.steps = 3;
    record.time = 6e-8;
    record.settled = true;
    record.packing_density = 0.1 + 0.2;
    record.largest_overlap = 1.0 / 7;
    record.end.wall_work = -1.0 / 3;
    progress.finished = {record, StageRecord{}};
    progress.energy.set_values({1, 2, 1.0 / 3});
    checkpoint.engine.reals["contacts/force"] = {1.0 / 3, -0.0, std::numeric_limits<double>::infinity(), 5e-324};
    checkpoint.engine.reals["empty"] = {};
    checkpoint.engine.integers["contacts/first"] = {-1, std::numeric_limits<std::int64_t>::max()};
    return checkpoint;
}

class CheckpointFile : public ::testing::Test {
protected:
    Checkpoint round_trip() {
        write_checkpoint(folder_ / "checkpoint.h5", sample());
        return read_checkpoint(folder_ / "checkpoint.h5");
    }
    testing::TemporaryFolder folder_;
};

TEST_F(CheckpointFile, KeepsTheEngineToTheBit) {
    const Checkpoint expected = sample(), read = round_trip();
    EXPECT_EQ(read.engine.reals, expected.engine.reals);
    EXPECT_EQ(read.engine.integers, expected.engine.integers);
    EXPECT_TRUE(std::signbit(read.engine.reals.at("contacts/force").at(1)));
}

TEST_F(CheckpointFile, KeepsTheProgress) {
    const Checkpoint expected = sample(), read = round_trip();
    EXPECT_EQ(read.version, "1.2");
    EXPECT_EQ(read.config, expected.config);
    // the text has every entry of the progress; numbers in it read back as the same doubles
    EXPECT_EQ(progress_to_text(read.progress), progress_to_text(expected.progress));
    EXPECT_EQ(read.progress.segment_steps, 1234567890123);
    EXPECT_EQ(read.progress.stage_wall_seconds, 1.0 / 3);
    EXPECT_EQ(read.progress.start.gravity, 1e-300);
    EXPECT_TRUE(read.progress.segment_entered && read.progress.settled);
    ASSERT_EQ(read.progress.finished.size(), 2U);
    EXPECT_EQ(read.progress.finished[0].packing_density, 0.1 + 0.2);
    EXPECT_EQ(read.progress.finished[0].end.wall_work, -1.0 / 3);
    EXPECT_FALSE(read.progress.finished[1].packing_density);
    EXPECT_EQ(read.progress.energy.values(), expected.progress.energy.values());
}

TEST_F(CheckpointFile, ReplacesAnOlderOneAndLeavesNothingElse) {
    round_trip();
    round_trip();
    std::size_t files = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder_.path())) ++files;
    EXPECT_EQ(files, 1U);
}

TEST_F(CheckpointFile, SaysWhatIsWrongWithAnotherFile) {
    const auto message = [&](const std::string& name) {
        return testing::message_of<InputError>([&] { read_checkpoint(folder_ / name); });
    };
    EXPECT_THAT(message("none.h5"), HasSubstr("there is no checkpoint"));
    write_text_file(folder_ / "text.h5", "hello");
    EXPECT_THAT(message("text.h5"), HasSubstr("text.h5"));
}

}  // namespace
}  // namespace recoat
