#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include <gtest/gtest.h>

#include "analyzer/fields/tangent_circles.hpp"
#include "analyzer/metrics/chamber_pores.hpp"
#include "tests/analyzer/support.hpp"

namespace recoat {
namespace {

using testing::Ball;
using testing::layer_of;
using testing::unit_config;

std::vector<Ball> random_disks(std::size_t count, double length, double width, bool equal, std::uint64_t seed) {
    std::vector<Ball> balls = testing::random_balls(count, length, width, seed);
    for (Ball& ball : balls) ball.radius = equal ? 0.35 : ball.radius;
    return balls;
}

/// Gap at a point to the disks and all their copies within three periods.
double gap(const std::vector<Disk>& copies, double x, double y) {
    double smallest = 1e300;
    for (const Disk& disk : copies) smallest = std::min(smallest, std::hypot(x - disk.x, y - disk.y) - disk.radius);
    return smallest;
}

/// Every triple of disks and copies, whatever their distance.
std::vector<Circle> from_all_triples(const Layer& layer) {
    const TopView view = top_view(layer);
    const std::vector<Disk> copies = view.tiled(1.5 * view.period);
    std::vector<Circle> found;
    for (std::size_t i = 0; i < copies.size(); ++i) {
        for (std::size_t j = i + 1; j < copies.size(); ++j) {
            for (std::size_t k = j + 1; k < copies.size(); ++k) {
                const Disk &a = copies[i], &b = copies[j], &c = copies[k];
                const bool left = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0;
                for (const Circle& circle : circles_between({a, left ? b : c, left ? c : b})) {
                    if (circle.y < 0 || circle.y >= view.period) continue;
                    if (gap(copies, circle.x, circle.y) < circle.radius - 1e-9) continue;
                    if (std::ranges::none_of(found, [&](const Circle& other) {
                            return std::hypot(other.x - circle.x, other.y - circle.y) < 1e-6;
                        }))
                        found.push_back(circle);
                }
            }
        }
    }
    std::ranges::sort(found, comes_first);
    return found;
}

void expect_same(const std::vector<Circle>& found, const std::vector<Circle>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_NEAR(found[i].radius, expected[i].radius, 1e-8);
        EXPECT_NEAR(found[i].x, expected[i].x, 1e-6);
        EXPECT_NEAR(found[i].y, expected[i].y, 1e-6);
    }
}

TEST(EmptyCircles, OfRandomDisksAreThoseOfAllTriples) {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        for (const bool equal : {true, false}) {
            const double width = seed % 3 == 0 ? 2 : 5;
            const Layer layer = layer_of(random_disks(3 + 2 * seed, 4, width, equal, seed), unit_config(4, width));
            expect_same(empty_circles(layer).maxima, from_all_triples(layer));
        }
    }
}

TEST(EmptyCircles, AreLocalMaximaOfTheGap) {
    const Layer layer = layer_of(random_disks(40, 8, 8, false, 3), unit_config(8, 8));
    const std::vector<Disk> copies = top_view(layer).tiled(20);
    const EmptyCircles circles = empty_circles(layer);
    EXPECT_FALSE(circles.persistent);
    ASSERT_GT(circles.maxima.size(), 10U);
    for (const Circle& circle : circles.maxima) {
        EXPECT_NEAR(gap(copies, circle.x, circle.y), circle.radius, 1e-9);
        for (int k = 0; k < 16; ++k) {
            EXPECT_LT(gap(copies, circle.x + 1e-4 * std::cos(k), circle.y + 1e-4 * std::sin(k)), circle.radius);
        }
    }
}

/// Memory with holes of all sizes: what is made next comes to lie in another order every time.
std::vector<std::unique_ptr<char[]>> scattered_memory(std::uint64_t seed) {
    std::mt19937_64 generator(seed);
    std::vector<std::unique_ptr<char[]>> kept(20'000);
    for (auto& block : kept) block = std::make_unique<char[]>(16 + generator() % 3000);
    std::ranges::shuffle(kept, generator);
    kept.resize(kept.size() / 2);
    return kept;
}

TEST(EmptyCircles, DoNotDependOnWhereMemoryLies) {
    // Circles within rounding of the seam of the period, which are found at both of its ends.
    std::vector<Ball> balls = random_disks(300, 300, 20, false, 5);
    for (int column = 0; column < 200; ++column) {
        const double radius = 0.3 + 0.1 * std::cos(column);
        for (const double y : {-0.7, 0.7}) balls.push_back({1.5 * column, y + 4e-4, 0.5, radius});
    }
    const Layer layer = layer_of(balls, unit_config(300, 20));
    const std::vector<Circle> once = empty_circles(layer).maxima;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        const auto memory = scattered_memory(seed);
        const std::vector<Circle> again = empty_circles(layer).maxima;
        ASSERT_EQ(again.size(), once.size());
        for (std::size_t i = 0; i < once.size(); ++i) {
            EXPECT_EQ(again[i].x, once[i].x);
            EXPECT_EQ(again[i].y, once[i].y);
            EXPECT_EQ(again[i].radius, once[i].radius);
        }
    }
}

TEST(EmptyCircles, OneFormulaForEqualAndUnequalRadii) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        std::vector<Ball> balls = random_disks(60, 9, 7, true, seed);
        const std::vector<Circle> delaunay = empty_circles(layer_of(balls, unit_config(9, 7))).maxima;
        balls.push_back({500, 3, 0.5, 0.3});
        std::vector<Circle> apollonius = empty_circles(layer_of(balls, unit_config(9, 7))).maxima;
        for (const auto& list : {delaunay, apollonius}) ASSERT_GT(list.size(), 10U);
        std::erase_if(apollonius, [](const Circle& circle) { return circle.x > 9; });
        std::vector<Circle> inner = delaunay;
        std::erase_if(inner, [](const Circle& circle) { return circle.x > 9; });
        expect_same(apollonius, inner);
    }
}

TEST(EmptyCircles, FewOrCollinearDisksLeaveNone) {
    const AnalysisConfig config = unit_config(6, 6);
    for (const std::vector<Ball>& balls : {std::vector<Ball>{},
                                           {{1, 1}},
                                           {{1, 1}, {1, 3}},
                                           {{2, 0}, {2, 1.5}, {2, 4}},
                                           {{2, 2}, {2, 2, 3}, {2, 2, 1.5, 0.3}}}) {
        const ChamberPoreMetrics metrics = chamber_pore_metrics(layer_of(balls, config), config);
        EXPECT_EQ(metrics.all.sizes.count, 0U);
        EXPECT_EQ(metrics.separate.sizes.mean, 0);
    }
    // Two disks and their copies: two circles, between one disk and two copies of the other.
    EXPECT_EQ(empty_circles(layer_of({{1, 1}, {4, 4}}, config)).maxima.size(), 2U);
}

TEST(EmptyCircles, LatticesAndCoincidentDisks) {
    std::vector<Ball> square, hexagonal;
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j) {
            square.push_back({i + 1e-9 * ((i * 7 + j * 3) % 5), j + 1e-9 * ((i * 5 + j) % 3)});
            square.push_back({1.0 * i, 1.0 * j, 1.5});
            hexagonal.push_back({i * std::sqrt(0.75), j + (i % 2) * 0.5});
        }
    }
    const EmptyCircles in_square = empty_circles(layer_of(square, unit_config(6, 6)));
    EXPECT_EQ(in_square.maxima.size(), 30U);
    for (const Circle& circle : in_square.maxima) EXPECT_NEAR(circle.radius, std::sqrt(0.5) - 0.5, 1e-8);
    EXPECT_EQ(empty_circles(layer_of(hexagonal, unit_config(6, 6))).maxima.size(), 60U);
    square[0].radius = 0.499;
    square[1].radius = 0.499;
    // The two squares beside the smaller disk hold a circle that touches it, and one at the right angle of the others.
    const std::vector<Circle> beside = empty_circles(layer_of(square, unit_config(6, 6))).maxima;
    EXPECT_EQ(beside.size(), 32U);
    EXPECT_EQ(std::ranges::count_if(beside, [](const Circle& c) { return c.radius > 0.20710725; }), 2);
}

/// The greedy rules written out over all pairs.
std::vector<double> selected(const std::vector<Circle>& candidates, double period, double factor, bool disjoint) {
    std::vector<Circle> taken;
    std::vector<double> sizes;
    for (const Circle& circle : candidates) {
        const bool meets = std::ranges::any_of(taken, [&](const Circle& other) {
            const double dy = std::abs(other.y - circle.y);
            const double distance = std::hypot(other.x - circle.x, std::min(dy, period - dy));
            return distance < (disjoint ? other.radius + circle.radius : factor * other.radius);
        });
        if (meets) continue;
        taken.push_back(circle);
        sizes.push_back(2 * circle.radius);
    }
    std::ranges::sort(sizes);
    return sizes;
}

TEST(ChamberPores, GreedyRulesAgreeWithAllPairs) {
    AnalysisConfig config = unit_config(30, 10);
    const Layer layer = layer_of(random_disks(170, 26, 10, false, 8), config);
    config.x_end = 1e4;
    Layer whole = layer;
    whole.length = 1e4;
    for (double& x : whole.x) x += 100;
    const std::vector<Circle> candidates = empty_circles(whole).maxima;
    ASSERT_GT(candidates.size(), 100U);
    for (const double factor : {0.0, 0.5, 1.0, 3.0, 40.0}) {
        config.chamber_f = factor;
        const ChamberPoreMetrics metrics = chamber_pore_metrics(whole, config);
        EXPECT_EQ(metrics.separate.sizes.sorted, selected(candidates, 10, factor, false)) << factor;
        EXPECT_EQ(metrics.disjoint.sizes.sorted, selected(candidates, 10, factor, true));
        EXPECT_EQ(metrics.all.sizes.count, candidates.size());
    }
}

TEST(ChamberPores, SmallestDiameterAndEdgeOfTheRegion) {
    AnalysisConfig config = unit_config(10, 10);
    const Layer layer = layer_of(random_disks(60, 10, 10, true, 4), config);
    const ChamberPores every = chamber_pore_metrics(layer, config).all;
    config.chamber_x_edge = ChamberEdge::inside;
    config.chamber_min_diameter = 0.8;
    const ChamberPores some = chamber_pore_metrics(layer, config).all;
    const auto expected = std::ranges::count_if(
        every.circles, [](const Circle& c) { return c.radius >= 0.4 && c.x - c.radius >= 0 && c.x + c.radius <= 10; });
    EXPECT_EQ(some.sizes.count, static_cast<std::size_t>(expected));
    EXPECT_LT(some.sizes.count, every.sizes.count);
    for (const Circle& circle : every.circles) EXPECT_TRUE(circle.x >= 0 && circle.x < 10);
}

/// Persistence on pixels: how far the gap falls on the best way to a higher pixel, by flooding from above.
TEST(ChamberPores, PersistenceAgreesWithFloodingOfPixels) {
    const AnalysisConfig config = unit_config(6, 6);
    std::vector<Ball> balls = random_disks(26, 6, 6, true, 11);
    // Walls, lest ways lead out of the data.
    for (int k = 0; k < 12; ++k) {
        for (const double x : {-2.2, 8.2}) balls.push_back({x, 0.5 * k, 0.5, 0.35});
    }
    const Layer layer = layer_of(balls, config);
    const std::vector<Disk> copies = top_view(layer).tiled(9);
    const auto [low, high] = std::ranges::minmax(layer.x);
    constexpr int n = 60;
    const int nx = static_cast<int>((high - low) * n), ny = 6 * n;
    std::vector<double> value(static_cast<std::size_t>(nx) * ny);
    for (int i = 0; i < nx; ++i) {
        for (int j = 0; j < ny; ++j) value[i * ny + j] = gap(copies, low + (i + 0.5) / n, (j + 0.5) / n);
    }
    const auto reaches_higher = [&](int start, double level, double height) {
        std::vector<int> stack = {start};
        std::vector<char> seen(value.size(), 0);
        seen[start] = 1;
        while (!stack.empty()) {
            const int here = stack.back();
            stack.pop_back();
            if (value[here] > height) return true;
            const int i = here / ny, j = here % ny;
            for (const auto& [a, b] : {std::pair(i + 1, j), {i - 1, j}, {i, (j + 1) % ny}, {i, (j + ny - 1) % ny}}) {
                if (a < 0 || a >= nx || seen[a * ny + b] || value[a * ny + b] < level) continue;
                seen[a * ny + b] = 1;
                stack.push_back(a * ny + b);
            }
        }
        return false;
    };
    const auto& found = empty_circles(layer).persistent;
    ASSERT_TRUE(found);
    int checked = 0;
    for (const auto& [circle, depth] : *found) {
        if (depth < 0.08) continue;
        const int start = static_cast<int>((circle.x - low) * n) * ny + static_cast<int>(circle.y * n);
        constexpr double pixel = 2.0 / n;
        const double height = circle.radius + pixel / 2;
        EXPECT_FALSE(reaches_higher(start, circle.radius - depth + pixel, height)) << circle.x << ' ' << circle.y;
        if (circle.radius - depth > pixel) {
            EXPECT_TRUE(reaches_higher(start, circle.radius - depth - pixel, circle.radius));
        }
        ++checked;
    }
    EXPECT_GT(checked, 5);
}

}  // namespace
}  // namespace recoat
