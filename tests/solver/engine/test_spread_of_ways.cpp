#include <random>

#include <gtest/gtest.h>

#include "solver/engine/spread_of_ways.hpp"
#include "solver/execution/openmp.hpp"
#include "tests/solver/engine/engine_scenes.hpp"

namespace recoat {
namespace {

using namespace testing;

TEST(SpreadOfWays, DoesNotCountWhatAllHaveGone) {
    SpreadOfWays ways;
    EXPECT_EQ(ways.widest(), 0);
    EXPECT_EQ(ways.farthest(), 0);
    ways.include({3, 4, 0});
    EXPECT_EQ(ways.widest(), 0);
    EXPECT_DOUBLE_EQ(ways.farthest(), 5);
    ways.include({3, 4, -2});
    EXPECT_DOUBLE_EQ(ways.widest(), 2);
    ways.include({});
    EXPECT_DOUBLE_EQ(ways.widest(), std::sqrt(9.0 + 16 + 4));
}

// Against all pairs: never less than two have come closer, and no more than the diagonal of a box is longer.
TEST(SpreadOfWays, BoundsTheApproachOfEveryPair) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    OpenMP space(2);
    for (int round = 0; round < 20; ++round) {
        std::vector<Row> before, now;
        for (int i = 0; i < 60; ++i) {
            before.push_back(row({normal(random), normal(random), normal(random)}));
            now.push_back(row(before.back().xyz() + Vec3{5 + normal(random), normal(random), 0.1 * normal(random)}));
        }
        double most = 0;
        for (std::size_t i = 0; i < now.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                most = std::max(most, norm(before[i].xyz() - before[j].xyz()) - norm(now[i].xyz() - now[j].xyz()));
        const double bound = spread_of_ways(space, now.data(), before.data(), now.size()).widest();
        EXPECT_GE(bound, most);
        double widest = 0;
        for (std::size_t i = 0; i < now.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                widest = std::max(widest, norm(now[i].xyz() - before[i].xyz() - now[j].xyz() + before[j].xyz()));
        EXPECT_GE(bound, widest);
        EXPECT_LE(bound, std::sqrt(3.0) * widest);
    }
}

/// Distance of two surfaces [m].
double gap(const EngineScene& scene, const ParticleTable& p, std::size_t i, std::size_t j) {
    Vec3 d = p.position[j] - p.position[i];
    d.y = std::remainder(d.y, scene.setup.y_period);
    return norm(d) - p.radius[i] - p.radius[j];
}

class Lists : public ::testing::TestWithParam<Variety> {};

// Pairs that touch or attract are listed, all of them, whenever one looks, while a bar sweeps through.
TEST_P(Lists, MissNoPair) {
    EngineScene scene = busy_box(GetParam());
    scene.walls[3].velocity = {0.05, 0, -0.1};
    const auto engine = scene.engine();
    const double range = scene.setup.model.hamaker > 0 ? scene.setup.model.cut_off : 0;
    std::size_t most = 0;
    for (int look = 0; look < 60; ++look) {
        engine->advance(7);
        const ParticleTable p = engine->particles();
        std::size_t pairs = 0, listed = 0;
        for (std::size_t i = 0; i < p.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) pairs += gap(scene, p, i, j) < range ? 1 : 0;
        for (const ContactState& contact : engine->contacts())
            listed += contact.second >= 0 && contact.separation < range;
        ASSERT_EQ(listed, pairs) << engine->step();
        most = std::max(most, pairs);
    }
    EXPECT_GT(most, 20u);
}

INSTANTIATE_TEST_SUITE_P(Varieties, Lists, ::testing::Values(Variety{0}, Variety{50, RollingForm::own, 0.6}));

}  // namespace
}  // namespace recoat
