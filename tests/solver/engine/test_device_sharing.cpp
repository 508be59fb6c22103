#include <numbers>
#include <thread>

#include <gtest/gtest.h>

#include "tests/solver/engine/engine_scenes.hpp"
#include "tests/support/device_on_host/cuda_runtime.h"

// Compiled with the host as the device (tests/support/device_on_host), which runs blocks of a kernel, and streams, at
// the same time: with the thread sanitizer what follows shows whether any of them get in each other's way.

namespace recoat {
namespace {

using namespace testing;

/// Enough particles that every loop of a step has many blocks.
EngineScene many_blocks(double bond, RollingForm rolling, double spread) {
    EngineScene scene = busy_box({bond, rolling, spread, 1300});
    scene.setup.resources = {Backend::cuda, 1, 0};
    return scene;
}

const std::vector<EngineScene>& scenes() {
    static const std::vector<EngineScene> all = {many_blocks(0, RollingForm::own, 1),
                                                 many_blocks(50, RollingForm::relative, 1),
                                                 many_blocks(50, RollingForm::own, 0.97)};
    return all;
}

constexpr std::int64_t steps = 45;  // about three times the life of a close list

std::vector<std::uint64_t> bits_after(const EngineScene& scene) {
    const auto engine = scene.engine();
    engine->advance(steps);
    return bits_of(*engine);
}

TEST(DeviceSharing, TheSceneHasManyBlocksAndItsListsChange) {
    const EngineScene& scene = scenes().back();
    const auto engine = scene.engine();
    const std::size_t before = engine->contacts().size();
    const std::uint64_t waits = host_device.waits;
    engine->advance(steps);
    // Steps and reading their end are two waits where no list is made anew; a list costs four.
    EXPECT_GT(host_device.waits - waits, 2u + 2 * 4);
    EXPECT_GT(scene.particles.size(), 8u * 128u);
    EXPECT_GT(engine->contacts().size(), 100u);
    EXPECT_NE(engine->contacts().size(), before);
}

// What looks for rest asks often: it must not fetch the particles.
TEST(DeviceSharing, KineticEnergyIsThatOfTheParticlesAndOneWait) {
    const EngineScene& scene = scenes().back();
    const auto engine = scene.engine();
    engine->advance(5);
    const std::uint64_t waits = host_device.waits;
    const double found = engine->kinetic_energy();
    EXPECT_EQ(host_device.waits - waits, 1u);
    const ParticleTable table = engine->particles();
    double expected = 0;
    for (std::size_t i = 0; i < table.size(); ++i) {
        const double r = table.radius[i], mass = 4.0 / 3 * std::numbers::pi * r * r * r * scene.setup.model.density;
        const double spin = squared_norm(table.angular_velocity[i]);
        expected += 0.5 * mass * (squared_norm(table.velocity[i]) + 0.4 * r * r * spin);
    }
    EXPECT_NEAR(found, expected, 1e-12 * expected);
}

// Cases of a sweep, each with a thread and a stream of its own: none changes a bit of another.
TEST(DeviceSharing, CasesOfASweepGetWhatTheyGetAlone) {
    std::vector<std::vector<std::uint64_t>> alone, together(scenes().size());
    for (const EngineScene& scene : scenes()) alone.push_back(bits_after(scene));
    std::vector<std::jthread> cases;
    for (std::size_t k = 0; k < scenes().size(); ++k)
        cases.emplace_back([&, k] { together[k] = bits_after(scenes()[k]); });
    cases.clear();  // waits for them
    for (std::size_t k = 0; k < scenes().size(); ++k) EXPECT_TRUE(alone[k] == together[k]) << k;
}

}  // namespace
}  // namespace recoat
