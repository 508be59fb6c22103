#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/error.hpp"
#include "solver/output/trajectory.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/throws_message.hpp"

namespace recoat {
namespace {

State state_at(std::int64_t step) {
    State state;
    state.step = step;
    state.time = 0.1 * static_cast<double>(step);
    state.id = {0};
    state.position = {{static_cast<double>(step), 0, 0}};
    state.velocity = {{}};
    state.angular_velocity = {{}};
    state.radius = {1};
    return state;
}

class TrajectoryFolder : public ::testing::Test {
protected:
    TrajectoryFolder() {
        for (std::int64_t i = 0; i < 4; ++i)
            fingerprints_.push_back(trajectory_.add(static_cast<std::size_t>(i), StateInfo{}, state_at(10 * i)));
    }

    testing::TemporaryFolder folder_;
    Trajectory trajectory_{folder_.path()};
    std::vector<std::uint64_t> fingerprints_;
};

TEST_F(TrajectoryFolder, FramesAreWholeFilesUntilTheyAreJoined) {
    EXPECT_EQ(read_state(folder_ / "trajectory.frames/000002.vtkhdf").step, 20);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "trajectory.vtkhdf"));
    fingerprints_[3] = trajectory_.add(3, StateInfo{}, state_at(31));  // a resumed run writes the frame again
    trajectory_.assemble(fingerprints_, StateInfo{});
    ASSERT_EQ(count_steps(folder_ / "trajectory.vtkhdf"), 4U);
    EXPECT_EQ(read_state(folder_ / "trajectory.vtkhdf", 1).position[0].x, 10);
    EXPECT_EQ(read_state(folder_ / "trajectory.vtkhdf", 3).step, 31);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "trajectory.frames"));
}

TEST_F(TrajectoryFolder, JoiningTwiceKeepsTheFile) {
    trajectory_.assemble(fingerprints_, StateInfo{});
    trajectory_.assemble(fingerprints_, StateInfo{});
    EXPECT_EQ(count_steps(folder_ / "trajectory.vtkhdf"), 4U);
}

TEST_F(TrajectoryFolder, RemovingTheFramesMayBeInterrupted) {
    std::filesystem::copy(folder_ / "trajectory.frames", folder_ / "kept");
    trajectory_.assemble(fingerprints_, StateInfo{});
    std::filesystem::remove(folder_ / "kept/000001.vtkhdf");
    std::filesystem::remove(folder_ / "kept/000003.vtkhdf");
    std::filesystem::rename(folder_ / "kept", folder_ / "trajectory.frames");
    trajectory_.assemble(fingerprints_, StateInfo{});
    ASSERT_EQ(count_steps(folder_ / "trajectory.vtkhdf"), 4U);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(read_state(folder_ / "trajectory.vtkhdf", i).step, 10 * i);
}

TEST_F(TrajectoryFolder, AFrameThatIsNotAsItWasWrittenIsRefused) {
    static_cast<void>(trajectory_.add(2, StateInfo{}, state_at(21)));
    EXPECT_THAT(testing::message_of<InputError>([&] { trajectory_.assemble(fingerprints_, StateInfo{}); }),
                ::testing::HasSubstr("000002.vtkhdf"));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "trajectory.vtkhdf"));
}

}  // namespace
}  // namespace recoat
