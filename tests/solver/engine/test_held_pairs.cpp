#include <gtest/gtest.h>

#include "bench/accuracy/held_pairs.hpp"
#include "tests/solver/engine/engine_scenes.hpp"

namespace recoat {
namespace {

using namespace testing;

HeldPairs after(const EngineScene& scene, std::int64_t warm, std::int64_t steps) {
    EngineSetup setup = scene.setup;
    setup.resources = {Backend::cpu, 1, 0};
    const auto engine = make_engine(setup, scene.particles, scene.walls);
    engine->advance(warm);
    HeldPairs found;
    HeldPairsOfStep step(*engine, setup);
    for (std::int64_t k = 0; k < steps; ++k) found.add(step());
    return found;
}

struct Flight {
    double bond;
    Precision precision;
};

class HeldPairsOf : public ::testing::TestWithParam<Flight> {};

// docs/physics.md section 2.5: collisions everywhere at 0.1 m/s, at rest nothing. What the attraction of those that
// leave all the same is not charged for is a small part of the wells of the pairs that there are.
TEST_P(HeldPairsOf, a_box_of_collisions_stay) {
    EngineScene scene = busy_box({GetParam().bond, RollingForm::own, 1, 600});
    scene.setup.precision = GetParam().precision;
    const HeldPairs found = after(scene, 60, 400);
    EXPECT_GT(found.held, 1000);
    RecordProperty("held", std::to_string(found.held));
    RecordProperty("left", std::to_string(found.left));
    EXPECT_EQ(found.left, 0) << "of " << found.held << ", by up to " << found.furthest << " m";
}

INSTANTIATE_TEST_SUITE_P(Flights, HeldPairsOf,
                         ::testing::Values(Flight{50, Precision::double_precision}, Flight{50, Precision::mixed},
                                           Flight{400, Precision::double_precision}, Flight{900, Precision::mixed}));

}  // namespace
}  // namespace recoat
