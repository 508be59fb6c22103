#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/state.hpp"
#include "solver/energy_watch.hpp"
#include "solver/run.hpp"
#include "tests/support/fake_engine.hpp"
#include "tests/support/scene_text.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/throws_message.hpp"

namespace recoat {
namespace {

using ::testing::HasSubstr;
using testing::message_of;

constexpr double mass = 2.899428219876e-10;

/// Gains `gain` J of kinetic energy per step out of nothing; particle 2 presses on the wall number 1.
class Leaky : public testing::FakeEngine {
public:
    Leaky(testing::FakeScript& script, const ParticleTable& particles, std::vector<Wall> walls, double gain)
        : FakeEngine(script, 1e-6, particles, std::move(walls)), gain_(gain) {}
    EnergyLedger ledger() const override {
        EnergyLedger ledger;
        ledger.kinetic_translation = 1e-12 + gain_ * static_cast<double>(step());
        return ledger;
    }
    std::vector<ContactState> contacts() const override { return {{2, -2, {}, -1e-9, 0, {}}, {0, 1, {}, 0, 0, {}}}; }

private:
    double gain_;
};

class Watch : public ::testing::Test {
protected:
    int run(double gain, const std::string& setting = "output.energy_interval=0 s") {
        const Scene scene = testing::scene_of(testing::spread_text, {"time_step=1e-6 s", setting});
        const EngineFactory factory{[&](const EngineSetup&, const ParticleTable& particles, std::vector<Wall> walls) {
                                        return std::make_unique<Leaky>(script_, particles, std::move(walls), gain);
                                    },
                                    {}};
        return run_scene(scene, {folder_ / "out", {Backend::cpu, 1, 0}, true, false, {}}, factory);
    }

    testing::FakeScript script_;
    testing::TemporaryFolder folder_;
};

TEST_F(Watch, EnergyFromNothingStopsTheRunWithParticlePartnerStepAndCause) {
    const std::string sentence = message_of<SimulationFault>([&] { run(1e-13); });
    for (const char* words : {"step 10000 ", "energy appears", "particle 2", "wall 'rear'", "reduce time_step", "w dt"})
        EXPECT_THAT(sentence, HasSubstr(words));
    EXPECT_EQ(read_state(folder_ / "out/fault.vtkhdf").step, 10000);
}

TEST_F(Watch, WrittenEnergyIsWatchedToo) {
    EXPECT_THAT(message_of<SimulationFault>([&] { run(1e-13, "output.energy_interval=100 us"); }),
                HasSubstr("step 100 "));
}

TEST_F(Watch, LosingEnergyIsNoBetter) {
    EXPECT_THAT(message_of<SimulationFault>([&] { run(-1e-13); }), HasSubstr("energy vanishes"));
}

// 56500 steps gain 5 % of what is exchanged.
TEST_F(Watch, SmallErrorsPass) { EXPECT_EQ(run(0.05 * 2e-12 / 56500), 0); }

// 40 particles, m g d_p each.
TEST(EnergyScale, CountsTheWeightOfTheParticlesInAnyCase) {
    const Scene scene = testing::scene_of(testing::spread_text);
    ParticleTable particles;
    particles.radius.assign(40, 25e-6);
    EXPECT_NEAR(energy_scale(scene, {}, {}, total_mass(particles, scene.model.density)), 40 * mass * 9.81 * 50e-6,
                1e-22);
    EnergyLedger end;
    end.dissipated_normal = 3e-12;
    end.gravity = -2e-12;
    EXPECT_NEAR(energy_scale(scene, {}, end, total_mass(particles, scene.model.density)),
                5e-12 + 40 * mass * 9.81 * 50e-6, 1e-22);
}

}  // namespace
}  // namespace recoat
