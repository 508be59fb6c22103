#include <cmath>
#include <fstream>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/error.hpp"
#include "common/output_file.hpp"
#include "solver/output/checkpoint.hpp"
#include "solver/output/file_seal.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/throws_message.hpp"

namespace recoat {
namespace {

using ::testing::AllOf;
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
    progress.frames = {1, 0xffffffffffffffffULL};
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
    record.layer_end = 0.1 + 0.7;
    record.largest_overlap = 1.0 / 7;
    record.end.wall_work = -1.0 / 3;
    progress.finished = {record, StageRecord{}};
    progress.energy.set_values({1, 2, 1.0 / 3});
    progress.walls.set_values({0, 5, 1.0 / 7, -1, -2, -3, 1, 2, 3});
    progress.blade_stop = {1.0 / 9, {1e-3, -0.0, 1.0 / 3}};
    checkpoint.engine.reals["contacts/force"] = {1.0 / 3, -0.0, std::numeric_limits<double>::infinity(), 5e-324};
    checkpoint.engine.reals["empty"] = {};
    checkpoint.engine.integers["contacts/first"] = {-1, std::numeric_limits<std::int64_t>::max()};
    return checkpoint;
}

class CheckpointFile : public ::testing::Test {
protected:
    Checkpoint round_trip() {
        write_checkpoint(folder_.path(), sample());
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
    EXPECT_EQ(read.progress.walls.values(), expected.progress.walls.values());
    EXPECT_EQ(read.progress.blade_stop.rear, 1.0 / 9);
    EXPECT_EQ(read.progress.blade_stop.x, expected.progress.blade_stop.x);
    EXPECT_EQ(read.progress.stage_wall_seconds, 1.0 / 3);
    EXPECT_EQ(read.progress.start.gravity, 1e-300);
    EXPECT_TRUE(read.progress.segment_entered && read.progress.settled);
    ASSERT_EQ(read.progress.finished.size(), 2U);
    EXPECT_EQ(read.progress.finished[0].packing_density, 0.1 + 0.2);
    EXPECT_EQ(read.progress.finished[0].end.wall_work, -1.0 / 3);
    EXPECT_FALSE(read.progress.finished[1].packing_density);
    EXPECT_EQ(read.progress.frames, expected.progress.frames);
    EXPECT_EQ(read.progress.energy.values(), expected.progress.energy.values());
}

TEST_F(CheckpointFile, KeepsTheOneBeforeAndNothingElse) {
    round_trip();
    round_trip();
    round_trip();
    std::size_t files = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder_.path())) ++files;
    EXPECT_EQ(files, 2U);
}

std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

// Every bit counts: those of the seal, of HDF5's own tables, of the arrays.
TEST_F(CheckpointFile, NoFlippedBitGoesUnnoticed) {
    round_trip();
    const std::filesystem::path file = folder_ / "checkpoint.h5";
    const std::string whole = bytes_of(file);
    ASSERT_TRUE(is_intact(file));
    std::size_t noticed = 0;
    constexpr std::size_t tries = 3000;
    for (std::size_t k = 0; k < tries; ++k) {
        const std::size_t bit = k * 7919 % (8 * whole.size());
        std::string spoilt = whole;
        spoilt[bit / 8] = static_cast<char>(spoilt[bit / 8] ^ (1 << bit % 8));
        std::ofstream(file, std::ios::binary) << spoilt;
        noticed += is_intact(file) ? 0 : 1;
    }
    EXPECT_EQ(noticed, tries);
    EXPECT_THAT(testing::message_of<InputError>([&] { read_checkpoint(file); }), HasSubstr("damaged"));
}

TEST_F(CheckpointFile, NoTruncationGoesUnnoticed) {
    round_trip();
    const std::filesystem::path file = folder_ / "checkpoint.h5";
    for (auto size = static_cast<std::int64_t>(bytes_of(file).size()) - 1; size >= 0; size -= 97) {
        std::filesystem::resize_file(file, static_cast<std::uintmax_t>(size));
        EXPECT_THROW(read_checkpoint(file), InputError) << size;
    }
}

class TwoCheckpoints : public CheckpointFile {
protected:
    TwoCheckpoints() {
        for (const std::int64_t step : {1, 2}) {
            Checkpoint checkpoint = sample();
            checkpoint.progress.segment_steps = step;
            write_checkpoint(folder_.path(), checkpoint);
        }
    }
    std::int64_t step_of_latest(bool note) {
        const LatestCheckpoint latest = read_latest_checkpoint(folder_.path());
        EXPECT_EQ(!latest.note.empty(), note) << latest.note;
        return latest.checkpoint.progress.segment_steps;
    }
    void spoil(const std::string& name) { write_text_file(folder_ / name, bytes_of(folder_ / name) + "x"); }
};

TEST_F(TwoCheckpoints, TheLastIsTaken) { EXPECT_EQ(step_of_latest(false), 2); }

TEST_F(TwoCheckpoints, TheEarlierIsTakenWhereTheLastIsDamagedOrMissing) {
    spoil("checkpoint.h5");
    EXPECT_EQ(step_of_latest(true), 1);
    std::filesystem::remove(folder_ / "checkpoint.h5");
    EXPECT_EQ(step_of_latest(true), 1);
}

TEST_F(TwoCheckpoints, ADamagedOneDoesNotReplaceTheWholeOneBeforeIt) {
    spoil("checkpoint.h5");
    write_checkpoint(folder_.path(), sample());
    std::filesystem::remove(folder_ / "checkpoint.h5");
    EXPECT_EQ(step_of_latest(true), 1);
}

TEST_F(TwoCheckpoints, WithoutAWholeOneThereIsOneSentence) {
    spoil("checkpoint.h5");
    spoil("checkpoint-previous.h5");
    EXPECT_THAT(testing::message_of<InputError>([&] { read_latest_checkpoint(folder_.path()); }),
                AllOf(HasSubstr("checkpoint.h5"), HasSubstr("damaged too"), HasSubstr("--overwrite")));
    remove_checkpoints(folder_.path());
    EXPECT_FALSE(has_checkpoint(folder_.path()));
    EXPECT_THAT(testing::message_of<InputError>([&] { read_latest_checkpoint(folder_.path()); }),
                HasSubstr("there is no checkpoint"));
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
