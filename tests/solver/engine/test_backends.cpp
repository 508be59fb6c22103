#include <gtest/gtest.h>

#include "solver/execution/devices.hpp"
#include "tests/solver/engine/engine_scenes.hpp"

namespace recoat {
namespace {

using namespace testing;

#ifdef RECOAT_STRICT_FP
constexpr double bound = 0;
#else
// Fused operations round differently, and collisions let that grow: within the steps below by some 1e4.
constexpr double bound = 1e-10;
#endif

std::unique_ptr<Engine> engine_on(Backend backend, EngineScene scene) {
    scene.setup.resources = {backend, 2, test_device()};
    return scene.engine();
}

void expect_alike(const Engine& a, const Engine& b) {
    ASSERT_EQ(a.step(), b.step());
    const ParticleTable p = a.particles(), q = b.particles();
    for (std::size_t i = 0; i < p.size(); ++i) {
        ASSERT_LE(norm(p.position[i] - q.position[i]), bound * dp) << i;
        ASSERT_LE(norm(p.velocity[i] - q.velocity[i]), bound * 0.1) << i;
        ASSERT_LE(norm(p.angular_velocity[i] - q.angular_velocity[i]), bound * 4000) << i;
    }
    const EnergyLedger e = a.ledger(), f = b.ledger();
    EXPECT_NEAR(e.stored(), f.stored(), bound * e.kinetic_translation);
    EXPECT_NEAR(e.dissipated(), f.dissipated(), bound * e.kinetic_translation);
}

class Backends : public ::testing::TestWithParam<Variety> {
protected:
    void SetUp() override {
        const Devices devices = cuda_devices();
        if (devices.found.empty()) GTEST_SKIP() << "no CUDA device: " << devices.problem;
    }

    static EngineScene scene() {
        Variety variety = GetParam();
        variety.particles = 300;
        return busy_box(variety);
    }
};

TEST_P(Backends, Agree) {
    const EngineScene small = scene();
    const auto host = engine_on(Backend::cpu, small), device = engine_on(Backend::cuda, small);
    for (const std::int64_t steps : {1, 99, 100}) {
        host->advance(steps);
        device->advance(steps);
        expect_alike(*host, *device);
    }
}

TEST_P(Backends, ContinueEachOther) {
    const EngineScene small = scene();
    const auto host = engine_on(Backend::cpu, small), device = engine_on(Backend::cuda, small);
    host->advance(200);
    device->advance(100);
    EngineSetup setup = small.setup;
    setup.resources = {Backend::cpu, 1, 0};
    const auto continued = restore_engine(setup, device->save());
    continued->advance(100);
    expect_alike(*host, *continued);
}

TEST_P(Backends, TwoRunsOfADeviceAreEqualToTheBit) {
    const EngineScene small = scene();
    const auto one = engine_on(Backend::cuda, small), other = engine_on(Backend::cuda, small);
    one->advance(150);
    for (const std::int64_t steps : {33, 110, 7}) other->advance(steps);
    EXPECT_EQ(bits_of(*one), bits_of(*other));
    EXPECT_EQ(one->save().reals, other->save().reals);
}

INSTANTIATE_TEST_SUITE_P(Varieties, Backends, ::testing::ValuesIn(varieties));

}  // namespace
}  // namespace recoat
