#include <gtest/gtest.h>

#include "solver/output/trajectory.hpp"
#include "tests/support/temporary_folder.hpp"

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

TEST(Trajectory, FramesAreWholeFilesUntilTheyAreJoined) {
    testing::TemporaryFolder folder;
    const Trajectory trajectory(folder.path());
    for (std::int64_t i = 0; i < 4; ++i) trajectory.add(i, StateInfo{}, state_at(10 * i));
    EXPECT_EQ(read_state(folder / "trajectory.frames/000002.vtkhdf").step, 20);
    EXPECT_FALSE(std::filesystem::exists(folder / "trajectory.vtkhdf"));
    trajectory.add(3, StateInfo{}, state_at(31));  // a resumed run writes the frame again
    trajectory.assemble(4, StateInfo{});
    ASSERT_EQ(count_steps(folder / "trajectory.vtkhdf"), 4U);
    EXPECT_EQ(read_state(folder / "trajectory.vtkhdf", 1).position[0].x, 10);
    EXPECT_EQ(read_state(folder / "trajectory.vtkhdf", 3).step, 31);
    EXPECT_FALSE(std::filesystem::exists(folder / "trajectory.frames"));
}

TEST(Trajectory, JoiningTwiceKeepsTheFile) {
    testing::TemporaryFolder folder;
    const Trajectory trajectory(folder.path());
    trajectory.add(0, StateInfo{}, state_at(5));
    trajectory.assemble(1, StateInfo{});
    trajectory.assemble(1, StateInfo{});
    EXPECT_EQ(count_steps(folder / "trajectory.vtkhdf"), 1U);
}

}  // namespace
}  // namespace recoat
