#include <random>

#include <gtest/gtest.h>

#include "solver/output/blade_stop.hpp"

namespace recoat {
namespace {

constexpr double diameter = 1;

ParticleTable spheres_at(const std::vector<double>& x) {
    ParticleTable table;
    for (const double place : x) table.position.push_back({place, 0, 0.5});
    table.radius.assign(x.size(), 0.5 * diameter);
    return table;
}

double end_of(const std::vector<double>& before, const std::vector<double>& after) {
    return layer_end({10, before}, spheres_at(after), diameter);
}

TEST(LayerEnd, IsTheBladeWhereNothingFlowsBack) {
    EXPECT_EQ(end_of({}, {}), 10);
    EXPECT_EQ(end_of({3, 8, 12, 14}, {3, 8, 12, 14}), 10);
    EXPECT_EQ(end_of({3, 8, 12, 14}, {5, 9.5, 11.0, 20}), 10) << "forwards, or back in front of the blade";
    EXPECT_EQ(end_of({3, 9.9}, {2.96, 9.86}), 10) << "less than a twentieth of the diameter";
}

TEST(LayerEnd, IsBehindTheFurthestThatCameThroughTheGap) {
    EXPECT_EQ(end_of({3, 12, 13}, {3, 7, 8.5}), 6.5);
    EXPECT_EQ(end_of({3, 12, 13}, {3, 8.5, 7}), 6.5);
}

TEST(LayerEnd, IsBehindWhatThesePushed) {
    // the sphere at 6.2 was hit by that which ends at 7, and itself hit that at 4.5
    EXPECT_EQ(end_of({12, 6.2, 4.5, 1}, {7, 5.2, 4.0, 1}), 3.5);
}

TEST(LayerEnd, LeavesOutWhatTheBladeItselfLeftRollingBack) {
    EXPECT_EQ(end_of({12, 3}, {7, 2}), 6.5) << "far behind what came through the gap";
}

/// No sphere comes back over the end, and over every place between the end and the blade one does.
TEST(LayerEnd, IsTheLargestPlaceThatNothingCameBackOver) {
    std::mt19937 generator(7);
    std::uniform_real_distribution<double> place(0, 20), way(-1.5, 1.5);
    for (int scene = 0; scene < 200; ++scene) {
        std::vector<double> before(12), after;
        for (double& x : before) x = place(generator);
        for (const double x : before) after.push_back(x + way(generator));
        const double end = end_of(before, after);
        const auto crossed = [&](double x) {
            for (std::size_t i = 0; i < before.size(); ++i) {
                if (before[i] - after[i] >= 0.05 && after[i] - 0.5 < x && x < before[i] + 0.5) return true;
            }
            return false;
        };
        EXPECT_FALSE(crossed(end));
        for (double x = end + 1e-3; x < 10; x += 1e-3) ASSERT_TRUE(crossed(x)) << scene << " at " << x;
    }
}

}  // namespace
}  // namespace recoat
