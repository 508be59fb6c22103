#include <random>

#include <gtest/gtest.h>

#include "common/error.hpp"
#include "tests/solver/engine/engine_scenes.hpp"
#include "tests/support/throws_message.hpp"

namespace recoat {
namespace {

using namespace testing;

class Restore : public ::testing::TestWithParam<Variety> {};

TEST_P(Restore, ContinuesToTheBit) {
    EngineScene scene = busy_box(GetParam());
    const auto whole = scene.engine();
    std::mt19937_64 random(11);
    for (int portion = 0; portion < 5; ++portion) {
        whole->advance(static_cast<std::int64_t>(random() % 300));
        EngineSetup setup = scene.setup;
        setup.resources.threads = 1 + portion % 3;
        const auto restored = restore_engine(setup, whole->save());
        ASSERT_EQ(restored->step(), whole->step());
        ASSERT_EQ(bits_of(*restored), bits_of(*whole)) << "at once, at step " << whole->step();
        const auto steps = static_cast<std::int64_t>(random() % 300);
        whole->advance(steps);
        restored->advance(steps);
        ASSERT_EQ(bits_of(*restored), bits_of(*whole)) << "at step " << whole->step();
        ASSERT_EQ(restored->save().reals, whole->save().reals);
        ASSERT_EQ(restored->save().integers, whole->save().integers);
    }
}

INSTANTIATE_TEST_SUITE_P(Varieties, Restore, ::testing::ValuesIn(varieties));

TEST(Restore, KeepsWallsOnTheirWay) {
    EngineScene scene = busy_box({50, RollingForm::own, 1, 200});
    scene.walls.push_back(box("piston", {-infinite, -infinite, 3.2 * dp}, {infinite, infinite, 4 * dp}));
    const auto whole = scene.engine();
    whole->advance(37);
    whole->set_wall_velocity(4, {0.01, 0, -0.05});
    whole->remove_wall(3);
    whole->advance(211);
    const auto restored = restore_engine(scene.setup, whole->save());
    EXPECT_EQ(restored->walls(), whole->walls());
    whole->advance(300);
    restored->advance(300);
    EXPECT_EQ(restored->walls(), whole->walls());
    EXPECT_EQ(restored->walls()[4].name, "piston");
    EXPECT_FALSE(restored->walls()[3].active);
    EXPECT_EQ(bits_of(*restored), bits_of(*whole));
}

TEST(Restore, WorksBeforeTheFirstStepAndWithoutParticles) {
    const EngineScene scene = busy_box({0, RollingForm::own, 1, 100});
    const auto whole = scene.engine();
    const auto restored = restore_engine(scene.setup, whole->save());
    whole->advance(100);
    restored->advance(100);
    EXPECT_EQ(bits_of(*restored), bits_of(*whole));
    EngineScene empty{paper_setup(), {}, {plane("base", {}, {0, 0, 1})}};
    const auto nothing = restore_engine(empty.setup, empty.engine()->save());
    nothing->advance(10);
    EXPECT_EQ(nothing->step(), 10);
}

TEST(Restore, NamesWhatADamagedStateLacks) {
    const EngineScene scene = busy_box({50, RollingForm::own, 1, 50});
    const EngineState whole = scene.engine()->save();
    for (const auto& [name, values] : whole.reals) {
        EngineState damaged = whole;
        damaged.reals.erase(name);
        EXPECT_NE(message_of<InputError>([&] { restore_engine(scene.setup, damaged); }).find(name), std::string::npos);
    }
    for (const auto& [name, values] : whole.integers) {
        EngineState damaged = whole;
        damaged.integers.erase(name);
        EXPECT_NE(message_of<InputError>([&] { restore_engine(scene.setup, damaged); }).find(name), std::string::npos);
    }
}

}  // namespace
}  // namespace recoat
