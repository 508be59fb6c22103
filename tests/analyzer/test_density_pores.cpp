#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

#include <gtest/gtest.h>

#include "analyzer/metrics/density_pores.hpp"
#include "tests/analyzer/support.hpp"

namespace recoat {
namespace {

using testing::unit_config;

/// Map of ones with zeros at the given cells.
Map map_with(int nx, int ny, const std::vector<GridCell>& cells) {
    Map map(0, nx, ny);
    std::ranges::fill(map.values, 1.0);
    for (const GridCell cell : cells) map.at(cell.ix, ((cell.iy % ny) + ny) % ny) = 0;
    return map;
}

DensityPoreMetrics measure(const Map& map, GridConnectivity connectivity = GridConnectivity::sides) {
    return density_pore_metrics(map, {.nx = map.nx, .ny = map.ny, .spacing = 1}, unit_config(map.nx, map.ny),
                                connectivity);
}

TEST(DensityPores, ARectangleAcrossThePeriod) {
    std::vector<GridCell> cells;
    for (int ix = 2; ix < 4; ++ix) {
        for (int iy = -3; iy < 2; ++iy) cells.push_back({ix, iy});
    }
    const DensityPoreMetrics metrics = measure(map_with(8, 9, cells));
    ASSERT_EQ(metrics.pores.size(), 1U);
    const DensityPore& pore = metrics.pores[0];
    EXPECT_FALSE(pore.percolates);
    EXPECT_FALSE(pore.touches_x_edge);
    EXPECT_NEAR(pore.diameter, std::sqrt(40 / std::numbers::pi), 1e-12);
    EXPECT_NEAR(pore.x, 3, 1e-12);
    EXPECT_NEAR(pore.y, 8.5, 1e-12);
    ASSERT_TRUE(pore.shape);
    EXPECT_NEAR(pore.shape->elongation, 2.5, 1e-12);
    EXPECT_NEAR(*pore.shape->angle, 90, 1e-12);
    EXPECT_NEAR(pore.shape->hull_area, 10, 1e-12);
    EXPECT_NEAR(pore.shape->hull_perimeter, 14, 1e-12);
    EXPECT_NEAR(pore.shape->rect_long, 5, 1e-12);
    EXPECT_NEAR(pore.shape->rect_short, 2, 1e-12);
    EXPECT_EQ(pore.shape->extent_x, 2);
    EXPECT_EQ(pore.shape->extent_y, 5);
    EXPECT_EQ(metrics.angle_cell_counts.back(), 10U);
    EXPECT_NEAR(metrics.area_fraction, 10.0 / 72, 1e-15);
    EXPECT_EQ(metrics.sizes.group_number_fraction[3], 1);
}

TEST(DensityPores, CornersConnectEightNeighboursOnly) {
    const Map map = map_with(6, 6, {{0, 0}, {1, 1}, {2, 2}, {5, 5}});
    EXPECT_EQ(measure(map).pores.size(), 4U);
    const DensityPoreMetrics eight = measure(map, GridConnectivity::sides_and_corners);
    ASSERT_EQ(eight.pores.size(), 2U);
    EXPECT_EQ(eight.pores[0].cells, 3U);
    EXPECT_TRUE(eight.pores[0].touches_x_edge);
    EXPECT_NEAR(*eight.pores[0].shape->angle, 45, 1e-10);
    EXPECT_NEAR(eight.pores[0].shape->rect_long, 3 * std::numbers::sqrt2, 1e-12);
    EXPECT_NEAR(eight.pores[0].shape->rect_short, std::numbers::sqrt2, 1e-12);
}

TEST(DensityPores, OneThatWindsRoundThePeriodHasNoShape) {
    std::vector<GridCell> row;
    for (int iy = 0; iy < 5; ++iy) row.push_back({3, iy});
    EXPECT_TRUE(measure(map_with(6, 5, row)).pores[0].percolates);
    EXPECT_FALSE(measure(map_with(6, 5, row)).pores[0].shape);
    row.pop_back();
    EXPECT_FALSE(measure(map_with(6, 5, row)).pores[0].percolates);
    EXPECT_TRUE(measure(map_with(6, 1, {{3, 0}})).pores[0].percolates);
}

TEST(DensityPores, TheThresholdIsStrict) {
    Map map = map_with(3, 3, {{1, 1}});
    map.at(1, 1) = 0.1;
    EXPECT_TRUE(measure(map).pores.empty());
    EXPECT_EQ(measure(map).sizes.mean, 0);
    map.at(1, 1) = std::nextafter(0.1, 0.0);
    EXPECT_EQ(measure(map).pores.size(), 1U);
}

/// Sets of connected cells by merging labels until nothing changes.
std::set<std::set<int>> sets_by_merging(const Map& map, bool corners) {
    std::vector<int> label(map.values.size());
    std::iota(label.begin(), label.end(), 0);
    for (bool changed = true; std::exchange(changed, false);) {
        for (int a = 0; a < map.nx * map.ny; ++a) {
            for (int b = 0; b < map.nx * map.ny; ++b) {
                if (map.values[a] >= 0.1 || map.values[b] >= 0.1 || label[b] <= label[a]) continue;
                const int dx = std::abs(a / map.ny - b / map.ny), dy = std::abs(a % map.ny - b % map.ny);
                const int near_y = std::min(dy, map.ny - dy);
                if (corners ? dx > 1 || near_y > 1 : dx + near_y > 1) continue;
                label[b] = label[a];
                changed = true;
            }
        }
    }
    std::map<int, std::set<int>> sets;
    for (int a = 0; a < map.nx * map.ny; ++a) {
        if (map.values[a] < 0.1) sets[label[a]].insert(a);
    }
    std::set<std::set<int>> result;
    for (const auto& [key, set] : sets) result.insert(set);
    return result;
}

TEST(DensityPores, RandomMapsAgreeWithMergingOfLabels) {
    std::mt19937_64 generator(5);
    for (int trial = 0; trial < 40; ++trial) {
        Map map(0, 9, 7);
        for (double& value : map.values) value = generator() % 2 == 0 ? 0.0 : 1.0;
        for (const auto connectivity : {GridConnectivity::sides, GridConnectivity::sides_and_corners}) {
            std::set<std::set<int>> found;
            for (const GridPore& pore : grid_pores(map, 0.1, connectivity)) {
                std::set<int> cells;
                for (const GridCell c : pore.cells) cells.insert(c.ix * 7 + ((c.iy % 7) + 7) % 7);
                EXPECT_EQ(cells.size(), pore.cells.size());
                found.insert(cells);
            }
            EXPECT_EQ(found, sets_by_merging(map, connectivity == GridConnectivity::sides_and_corners));
        }
    }
}

TEST(PixelShape, RectangularCellsAreAsManySquares) {
    std::mt19937_64 generator(7);
    for (int trial = 0; trial < 20; ++trial) {
        std::vector<GridCell> cells, squares;
        for (int k = 0; k < 7; ++k) {
            const GridCell cell = {static_cast<int>(generator() % 9), static_cast<int>(generator() % 9)};
            const auto same = [cell](GridCell other) { return other.ix == cell.ix && other.iy == cell.iy; };
            if (std::ranges::any_of(cells, same)) continue;
            cells.push_back(cell);
            for (int i = 0; i < 3; ++i) {
                for (int j = 0; j < 2; ++j) squares.push_back({3 * cell.ix + i, 2 * cell.iy + j});
            }
        }
        const PixelShape shape = pixel_shape(cells, {0.6, 0.4}), fine = pixel_shape(squares, {0.2, 0.2});
        EXPECT_NEAR(shape.elongation, fine.elongation, 1e-12);
        EXPECT_NEAR(shape.angle.value_or(-1), fine.angle.value_or(-1), 1e-9);
        EXPECT_NEAR(shape.hull_area, fine.hull_area, 1e-12);
        EXPECT_NEAR(shape.hull_perimeter, fine.hull_perimeter, 1e-12);
        EXPECT_NEAR(shape.rect_long * shape.rect_short, fine.rect_long * fine.rect_short, 1e-12);
        EXPECT_NEAR(shape.extent_x, fine.extent_x, 1e-12);
        EXPECT_NEAR(shape.extent_y, fine.extent_y, 1e-12);
    }
}

TEST(DensityPores, OfRectangularCells) {
    const Map map = map_with(10, 9, {{2, 8}, {2, 0}, {3, 8}, {3, 0}, {4, 8}, {4, 0}});
    const Grid grid = {.nx = 10, .ny = 9, .spacing = 1, .stretch_x = 1.1, .stretch_y = 0.9};
    const DensityPoreMetrics metrics = density_pore_metrics(map, grid, unit_config(11, 8.1), GridConnectivity::sides);
    ASSERT_EQ(metrics.pores.size(), 1U);
    const DensityPore& pore = metrics.pores[0];
    EXPECT_NEAR(pore.area, 6 * 0.99, 1e-12);
    EXPECT_NEAR(pore.diameter, std::sqrt(4 * 6 * 0.99 / std::numbers::pi), 1e-12);
    EXPECT_NEAR(pore.x, 3.5 * 1.1, 1e-12);
    EXPECT_NEAR(std::remainder(pore.y, 8.1), 0, 1e-12);
    EXPECT_NEAR(pore.shape->elongation, 3.3 / 1.8, 1e-12);
    EXPECT_NEAR(pore.shape->hull_perimeter, 2 * (3.3 + 1.8), 1e-12);
}

TEST(PixelShape, SmallestRectangleAgreesWithAScanOverAngles) {
    std::mt19937_64 generator(6);
    for (int trial = 0; trial < 30; ++trial) {
        std::vector<GridCell> cells;
        for (int k = 0; k < 6; ++k)
            cells.push_back({static_cast<int>(generator() % 9), static_cast<int>(generator() % 9)});
        const PixelShape shape = pixel_shape(cells, {1, 1});
        double smallest = 1e300;
        constexpr int steps = 9000;
        for (int k = 0; k < steps; ++k) {
            const double angle = 0.5 * std::numbers::pi * k / steps;
            double low_u = 1e9, high_u = -1e9, low_v = 1e9, high_v = -1e9;
            for (const GridCell cell : cells) {
                for (const auto& [x, y] : {std::pair(0, 0), {1, 0}, {0, 1}, {1, 1}}) {
                    const double u = (cell.ix + x) * std::cos(angle) + (cell.iy + y) * std::sin(angle);
                    const double v = (cell.iy + y) * std::cos(angle) - (cell.ix + x) * std::sin(angle);
                    low_u = std::min(low_u, u), high_u = std::max(high_u, u);
                    low_v = std::min(low_v, v), high_v = std::max(high_v, v);
                }
            }
            smallest = std::min(smallest, (high_u - low_u) * (high_v - low_v));
        }
        EXPECT_LE(shape.rect_long * shape.rect_short, smallest * (1 + 1e-12));
        EXPECT_GE(shape.rect_long * shape.rect_short, smallest * (1 - 1e-3));
        EXPECT_GE(shape.rect_long * shape.rect_short, shape.hull_area);
    }
}

}  // namespace
}  // namespace recoat
