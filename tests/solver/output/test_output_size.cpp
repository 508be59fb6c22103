#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/state.hpp"
#include "solver/output/output_size.hpp"
#include "tests/support/scene_text.hpp"
#include "tests/support/temporary_folder.hpp"

namespace recoat {
namespace {

using ::testing::HasSubstr;

// Fill 500 000 steps of 20 ns at most, heap 1 000 000, spread 1 325 000.
TEST(OutputSize, CountsWhatTheScenesIntervalsMean) {
    const Scene scene = testing::scene_of(testing::spread_text, {"output.trajectory_interval=1 ms"});
    const OutputSize size = output_size(scene, 40, 1000);
    EXPECT_EQ(size.frames, 2'825'000 / 50'000 + 1);
    EXPECT_EQ(size.states, 3 * size.frame);
    EXPECT_EQ(size.checkpoints, 2000);
    EXPECT_GT(size.most(), size.left() + size.trajectory());
    EXPECT_EQ(output_size(testing::scene_of(testing::spread_text), 40, 0).frames, 0);
}

// A file of particles in motion, whose numbers do not shrink much when they are deflated.
TEST(OutputSize, AStateIsAsLargeAsItSays) {
    const testing::TemporaryFolder folder;
    State state;
    const std::size_t count = 5000;
    std::uint64_t random = 1;
    const auto next = [&] {
        random = random * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<double>(random >> 11) * 0x1p-53;
    };
    for (std::size_t i = 0; i < count; ++i) {
        state.id.push_back(static_cast<std::int64_t>(i));
        state.radius.push_back(25e-6);
        state.position.push_back({next(), next(), next()});
        state.velocity.push_back({next(), next(), next()});
        state.angular_velocity.push_back({next(), next(), next()});
    }
    state.scalars["CoordinationNumber"].assign(count, 3);
    write_state(folder / "a.vtkhdf", {}, state);
    const double expected = output_size(testing::scene_of(testing::spread_text), count, 0).frame;
    const auto real = static_cast<double>(std::filesystem::file_size(folder / "a.vtkhdf"));
    EXPECT_LE(real, expected);
    EXPECT_GT(real, 0.5 * expected);
}

TEST(OutputSize, SaysWhereTheDiskHasLess) {
    const testing::TemporaryFolder folder;
    OutputSize size;
    EXPECT_EQ(space_note(size, folder / "not/yet/there"), "");
    size.frames = 1'000'000;
    size.frame = 1e12;
    EXPECT_THAT(space_note(size, folder.path()), HasSubstr("1 000 000 states of the trajectory"));
    size.frames = 0;
    size.states = 1e18;
    EXPECT_THAT(space_note(size, folder.path()), HasSubstr("the disk has"));
}

TEST(OutputSize, OfAnEngineIsThatOfItsNumbers) {
    EngineState state;
    state.reals["a"] = {1, 2, 3};
    state.integers["b"] = {1};
    EXPECT_EQ(engine_bytes(state), 32);
}

}  // namespace
}  // namespace recoat
