#include <gtest/gtest.h>

#include "tests/solver/engine/engine_scenes.hpp"

namespace recoat {
namespace {

using namespace testing;

std::vector<std::uint64_t> bits_after(EngineScene scene, int threads, std::int64_t steps) {
    scene.setup.resources.threads = threads;
    const auto engine = scene.engine();
    engine->advance(steps);
    return bits_of(*engine);
}

class Threads : public ::testing::TestWithParam<Variety> {};

TEST_P(Threads, DoNotChangeABit) {
    // Small loops stay on one thread: this needs some thousands of particles.
    Variety many = GetParam();
    many.particles = 3700;
    const EngineScene scene = busy_box(many);
    const auto one = bits_after(scene, 1, 70);
    EXPECT_TRUE(one == bits_after(scene, 2, 70));
    EXPECT_TRUE(one == bits_after(scene, 3, 70));
}

// The box must be busy for the test above to mean something: contacts everywhere, lists made anew, energy lost.
TEST_P(Threads, HaveSomethingToDo) {
    const EngineScene scene = busy_box(GetParam());
    const auto engine = scene.engine();
    const std::size_t before = engine->contacts().size();
    engine->advance(150);
    std::size_t touching = 0, walls = 0;
    for (const ContactState& c : engine->contacts()) {
        touching += c.separation < 0;
        walls += c.second < 0;
    }
    EXPECT_GT(touching, 20u);
    EXPECT_GT(walls, 5u);
    EXPECT_NE(engine->contacts().size(), before);
    const EnergyLedger ledger = engine->ledger();
    EXPECT_GT(ledger.dissipated_normal, 0);
    EXPECT_GT(ledger.dissipated_tangential, 0);
    EXPECT_GT(ledger.dissipated_rolling, 0);
    EXPECT_EQ(ledger.cohesion<0, GetParam().bond> 0);
}

TEST(Threads, StepsCanBeTakenInAnyPortions) {
    const EngineScene scene = busy_box({50, RollingForm::own, 1, 200});
    const auto whole = scene.engine(), portions = scene.engine();
    whole->advance(700);
    for (const std::int64_t steps : {1, 0, 99, 350, 250}) {
        portions->advance(steps);
        // Looking must not change anything.
        static_cast<void>(portions->contacts());
        static_cast<void>(portions->ledger());
    }
    EXPECT_EQ(whole->step(), 700);
    EXPECT_EQ(bits_of(*whole), bits_of(*portions));
}

INSTANTIATE_TEST_SUITE_P(Varieties, Threads, ::testing::ValuesIn(varieties));

}  // namespace
}  // namespace recoat
