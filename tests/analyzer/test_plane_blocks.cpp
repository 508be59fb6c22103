#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "analyzer/fields/empty_circles.hpp"
#include "analyzer/fields/plane_blocks.hpp"
#include "tests/analyzer/support.hpp"

namespace recoat {
namespace {

using testing::Ball;
using testing::layer_of;
using testing::unit_config;

/// Random disks; with `hole`, none between x = 40 and 100, so that blocks have to reach far.
std::vector<Ball> disks(std::size_t count, double length, double width, bool equal, bool hole) {
    std::vector<Ball> balls;
    for (Ball ball : testing::random_balls(count, length, width, 17)) {
        if (equal) ball.radius = 0.35;
        if (!hole || ball.x < 40 || ball.x > 100) balls.push_back(ball);
    }
    return balls;
}

double nearest_centre(const TopView& view, double x, double y) {
    double nearest = 1e300;
    for (const Disk& disk : view.disks) {
        const double gap = std::abs(y - disk.y);
        nearest = std::min(nearest, std::hypot(x - disk.x, std::min(gap, view.period - gap)));
    }
    return nearest;
}

TEST(PlaneBlocks, NoPointIsFartherFromACentreThanTheBound) {
    for (const bool hole : {false, true}) {
        for (const double width : {3.0, 30.0}) {
            const TopView view = top_view(layer_of(disks(300, 150, width, true, hole), unit_config(150, width)));
            const double bound = farthest_from_centres(view);
            const auto [first, last] = std::ranges::minmax(view.disks, {}, &Disk::x);
            double farthest = 0;
            for (double x = first.x; x <= last.x; x += 0.37) {
                for (double y = 0; y < width; y += 0.37) farthest = std::max(farthest, nearest_centre(view, x, y));
            }
            EXPECT_GE(bound, farthest);
            EXPECT_LT(bound, 6 * farthest + 1);
        }
    }
}

TEST(PlaneBlocks, EveryPointHasOneBlockAndItsNeighboursInIt) {
    const TopView view = top_view(layer_of(disks(30'000, 400, 90, true, false), unit_config(400, 90)));
    constexpr double margin = 5;
    const std::vector<PlaneBlock> blocks = plane_blocks(view, margin);
    ASSERT_GT(blocks.size(), 4U);
    for (int k = 0; k < 200; ++k) {
        const double x = std::fmod(k * 77.77, 400), y = std::fmod(k * 31.7, 90);
        const auto holds = [&](const PlaneBlock& block) { return block.holds(x, y); };
        ASSERT_EQ(std::ranges::count_if(blocks, holds), 1);
        const PlaneBlock& block = *std::ranges::find_if(blocks, holds);
        std::vector<std::size_t> found, expected;
        for (const Disk& disk : block.disks) {
            if (std::hypot(disk.x - x, disk.y - y) < margin) found.push_back(disk.index);
        }
        for (const Disk& disk : view.disks) {
            const double gap = std::abs(disk.y - y);
            if (std::hypot(disk.x - x, std::min(gap, 90 - gap)) < margin) expected.push_back(disk.index);
        }
        std::ranges::sort(found);
        EXPECT_EQ(found, expected);
    }
}

std::vector<double> radii(const std::vector<Circle>& circles) {
    std::vector<double> result;
    for (const Circle& circle : circles) result.push_back(circle.radius);
    return result;
}

/// Moves the layer, so that the edges of the blocks and of the period lie elsewhere; what fits in between must not
/// change.
TEST(PlaneBlocks, CirclesDoNotDependOnWhereTheBlocksEnd) {
    for (const bool equal : {true, false}) {
        for (const bool hole : {false, true}) {
            std::vector<Ball> balls = disks(12'000, 400, 33, equal, hole);
            const EmptyCircles here = empty_circles(layer_of(balls, unit_config(400, 33)));
            for (Ball& ball : balls) ball.y += 11.3;
            // Farther ends of the data move the blocks along x.
            for (int k = 0; k < 33; ++k) balls.push_back({-70, 1.0 * k, 0.5, equal ? 0.35 : 0.4});
            EmptyCircles there = empty_circles(layer_of(balls, unit_config(400, 33)));
            const auto outside = [](const Circle& c) { return c.x < 0 || c.x > 398; };
            std::vector<Circle> first = here.maxima, second = there.maxima;
            std::erase_if(first, outside);
            std::erase_if(second, outside);
            ASSERT_GT(first.size(), 3000U);
            const std::vector<double> expected = radii(first), found = radii(second);
            ASSERT_EQ(found.size(), expected.size());
            for (std::size_t k = 0; k < found.size(); ++k) EXPECT_NEAR(found[k], expected[k], 1e-9);
        }
    }
}

TEST(PlaneBlocks, ALatticeOverManyBlocks) {
    // Squares of side 1.2: one circle each, the same way out on all sides.
    std::vector<Ball> balls;
    constexpr int nx = 400, ny = 60;
    for (int i = 0; i < nx; ++i) {
        for (int j = 0; j < ny; ++j) balls.push_back({1.2 * i, 1.2 * j});
    }
    const EmptyCircles circles = empty_circles(layer_of(balls, unit_config(480, 72)));
    ASSERT_EQ(circles.maxima.size(), static_cast<std::size_t>((nx - 1) * ny));
    for (const Circle& circle : circles.maxima) ASSERT_NEAR(circle.radius, 0.6 * std::sqrt(2.0) - 0.5, 1e-9);
    ASSERT_TRUE(circles.persistent);
    const auto deep = [&](double least) {
        return std::ranges::count_if(*circles.persistent, [&](const auto& c) { return c.persistence > least; });
    };
    EXPECT_EQ(deep(0.6 * std::sqrt(2.0) - 0.6 - 1e-9), (nx - 1) * ny);
    EXPECT_EQ(deep(0.6 * std::sqrt(2.0) - 0.6 + 1e-9), 1);
}

}  // namespace
}  // namespace recoat
