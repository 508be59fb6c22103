#include <gtest/gtest.h>

#include "tests/support/small_scene.hpp"
#include "tests/support/verification.hpp"

namespace recoat {
namespace {

using testing::SmallScene;
using testing::verify;
using testing::verify_relative;
namespace powder = testing::powder;

// docs/physics.md section 5.8: 1 mm from rest, t = sqrt(2 h/g), v = sqrt(2 g h). Leapfrog with a half kick at the start
// is exact, but for the rounding of some 10^6 steps.
TEST(FreeFall, from_rest_is_exact_to_round_off) {
    constexpr double time = 1.427843122927e-2, speed = 1.400714103591e-1;
    constexpr std::int64_t steps = 713922;
    SmallScene scene(powder::model(0.001, 50), time / steps);
    scene.setup.gravity = {0, 0, -powder::gravity};
    scene.sphere({0, 0, 0});
    const auto engine = scene.engine();
    engine->advance(steps);
    const ParticleTable now = engine->particles();
    verify_relative("way", now.position[0].z, -1e-3, 1e-10);
    verify_relative("speed", now.velocity[0].z, -speed, 1e-10);
}

TEST(FreeFall, from_a_throw_is_exact_to_round_off) {
    SmallScene scene(powder::model(0.001, 50), 2e-8);
    scene.setup.gravity = {0, 0, -powder::gravity};
    scene.sphere({0, 0, 0}, {0.01, 0, 0.02});
    const auto engine = scene.engine();
    engine->advance(713921);
    const double t = 713921 * 2e-8;
    const ParticleTable now = engine->particles();
    verify("height [m]", now.position[0].z - (0.02 * t - 0.5 * powder::gravity * t * t), 1e-13);
    verify("way along x [m]", now.position[0].x - 0.01 * t, 1e-14);
    verify("speed [m/s]", now.velocity[0].z - (0.02 - powder::gravity * t), 1e-11);
}

}  // namespace
}  // namespace recoat
