#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/reference.hpp"
#include "tests/support/small_scene.hpp"
#include "tests/support/verification.hpp"

namespace recoat {
namespace {

using testing::over_plane;
using testing::reference;
using testing::verify_relative;
namespace powder = testing::powder;

// docs/physics.md section 5.8: (3 m g/(4 E* sqrt R))^(2/3) under the weight.
TEST(StaticOverlap, of_the_weight_is_that_of_hertz) {
    for (const double ratio : {1.0, 0.1, 0.01, 0.001}) {
        auto scene = over_plane(powder::model(ratio), ratio == 1 ? 2e-9 : 2e-8, 0, {});
        scene.setup.gravity = {0, 0, -powder::gravity};
        const auto engine = scene.engine();
        engine->advance(200000);
        const double overlap = powder::radius - engine->particles().position[0].z;
        verify_relative("overlap", overlap, reference("weight.overlap") * std::pow(ratio, -2.0 / 3), 5e-7,
                        std::to_string(ratio));
        verify_relative("force", engine->contacts().at(0).normal_force, powder::weight, 1e-14, std::to_string(ratio));
    }
}

// (F_r/k_H)^(2/3) by attraction alone, which goes as r^(-2/5).
TEST(StaticOverlap, of_the_attraction_scales_with_the_stiffness) {
    for (const int bond : {1, 5, 50, 200, 400})
        for (const double ratio : {1.0, 0.1, 0.01, 0.001}) {
            const auto model = powder::model(ratio, bond);
            const double time_step = ratio == 1 ? 2e-9 : 2e-8, scale = std::pow(ratio, -0.4);
            const auto pair = testing::head_on_pair(model, time_step, 0, 0).engine();
            const auto wall = over_plane(model, time_step, 0, {}).engine();
            pair->advance(20000);
            wall->advance(20000);
            const std::string name = std::to_string(bond), where = name + ", r = " + std::to_string(ratio);
            verify_relative("overlap of a pair", -testing::pair_separation(pair->particles()),
                            scale * reference("equilibrium.pair." + name), 3e-6, where);
            verify_relative("overlap with a wall", powder::radius - wall->particles().position[0].z,
                            scale * reference("equilibrium.wall." + name), 1e-5, where);
        }
}

}  // namespace
}  // namespace recoat
