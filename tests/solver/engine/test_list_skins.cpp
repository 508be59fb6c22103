#include <algorithm>

#include <gtest/gtest.h>

#include "tests/solver/engine/engine_scenes.hpp"

namespace recoat {
namespace {

using namespace testing;

ParticleTable after(EngineScene scene, ListSkins skins, std::int64_t steps) {
    scene.setup.skins = skins;
    const auto engine = scene.engine();
    engine->advance(steps);
    return engine->particles();
}

/// Largest distance of a particle from where the other table has it [d_p].
double difference(const ParticleTable& a, const ParticleTable& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, norm(a.position[i] - b.position[i]) / dp);
    return largest;
}

class Skins : public ::testing::TestWithParam<Variety> {};

// Lists that last shorter or longer hold the same contacts: only the order of sums may differ, which collisions
// enlarge (4e-10 in one build).
TEST_P(Skins, DoNotChangeTheMotion) {
    const EngineScene scene = busy_box(GetParam());
    const ParticleTable usual = after(scene, {}, 200);
    for (const ListSkins skins : {ListSkins{0.03, 100}, {0.5, 100}, {0.1, 1}, {0.1, 100}, {0.1, 1000}, {0.9, 5000}})
        EXPECT_LT(difference(after(scene, skins, 200), usual), 1e-8) << skins.far << ", " << skins.close_steps;
}

INSTANTIATE_TEST_SUITE_P(Varieties, Skins,
                         ::testing::Values(Variety{0}, Variety{50}, Variety{50, RollingForm::relative, 0.6}));

TEST(Skins, OfAShortPeriodAreRefused) {
    EngineScene scene = busy_box({0});
    scene.setup.skins.far = 3.5;
    EXPECT_THROW((void)scene.engine(), std::exception);
}

}  // namespace
}  // namespace recoat
