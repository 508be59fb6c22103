#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "solver/cli/calibration.hpp"
#include "tests/support/fake_engine.hpp"
#include "tests/support/scene_text.hpp"

namespace recoat {
namespace {

using Clock = std::chrono::steady_clock;

/// An engine whose steps take a time that is known: calculating, or as if other programs had the processor.
class SlowEngine : public testing::FakeEngine {
public:
    SlowEngine(testing::FakeScript& script, double time_step, const ParticleTable& particles, bool away)
        : FakeEngine(script, time_step, particles, {}), away_(away) {}
    void advance(std::int64_t steps) override {
        const auto end = Clock::now() + steps * std::chrono::microseconds(500);
        if (away_) std::this_thread::sleep_until(end);
        while (Clock::now() < end) {
        }
    }

private:
    bool away_;
};

Calibration measure(bool away) {
    testing::FakeScript script;
    const EngineFactory factory{[&](const EngineSetup& setup, const ParticleTable& particles, std::vector<Wall>) {
                                    return std::make_unique<SlowEngine>(script, setup.time_step, particles, away);
                                },
                                {}};
    return calibrate(testing::scene_of(testing::spread_text), 1000, {Backend::cpu, 1, 0}, factory);
}

TEST(Calibration, TakesTheBestOfItsMeasurements) {
    // 2000 steps per second at best, of 1000 particles
    const Calibration found = measure(false);
    EXPECT_EQ(found.particles, 1000U);
    EXPECT_LE(found.particle_steps_per_second, 2.01e6);
    EXPECT_GE(found.particle_steps_per_second, 1.5e6);
    // 7 numbers of each particle are saved, and a few of the engine
    EXPECT_NEAR(found.checkpoint_bytes_per_particle, 7 * 8, 0.1);
}

TEST(Calibration, SaysThatTheProcessorWasElsewhere) {
    const Calibration found = measure(true);
    EXPECT_TRUE(found.busy());
    EXPECT_LT(found.processor_share, 0.5);
}

TEST(Calibration, OfWhatFliesApartIsNone) {
    testing::FakeScript script;
    script.fault_at = 1;
    const Calibration found =
        calibrate(testing::scene_of(testing::spread_text), 8, {Backend::cpu, 1, 0}, testing::fake_factory(script));
    EXPECT_EQ(found.particle_steps_per_second, 0);
}

}  // namespace
}  // namespace recoat
