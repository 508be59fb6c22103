#include <gtest/gtest.h>

#include "analyzer/fields/packing_map.hpp"
#include "analyzer/fields/sphere_box.hpp"
#include "tests/analyzer/support.hpp"

namespace recoat {
namespace {

using testing::fitted;
using testing::layer_of;
using testing::random_balls;
using testing::unit_config;

/// Window box of a node.
struct Window {
    Vec3 lower, upper;
};

Window window_of(const Layer& layer, const AnalysisConfig& config, int ix, int iy) {
    const double side_x = fitted(layer.length, config.grid), side_y = fitted(layer.width, config.grid);
    const double cells = config.phi_window / config.grid;
    return {{side_x * (ix + 0.5 - cells / 2), side_y * (iy + 0.5 - cells / 2), 0},
            {side_x * (ix + 0.5 + cells / 2), side_y * (iy + 0.5 + cells / 2), layer.clearance}};
}

double box_of(const Window& window) {
    return (window.upper.x - window.lower.x) * (window.upper.y - window.lower.y) * window.upper.z;
}

/// The definition as it stands: every sphere and its images, one window at a time.
double exact_at(const Layer& layer, const AnalysisConfig& config, int ix, int iy) {
    const Window window = window_of(layer, config, ix, iy);
    double volume = 0;
    for (std::size_t i = 0; i < layer.size(); ++i) {
        for (const double shift : {-layer.width, 0.0, layer.width}) {
            volume += sphere_box_volume({layer.x[i], layer.y[i] + shift, layer.z[i]}, layer.radius[i], window.lower,
                                        window.upper);
        }
    }
    return volume / box_of(window);
}

double centre_at(const Layer& layer, const AnalysisConfig& config, int ix, int iy) {
    const Window window = window_of(layer, config, ix, iy);
    double volume = 0;
    for (std::size_t i = 0; i < layer.size(); ++i) {
        for (const double shift : {-layer.width, 0.0, layer.width}) {
            const double y = layer.y[i] + shift;
            const bool inside = layer.x[i] >= window.lower.x && layer.x[i] < window.upper.x && y >= window.lower.y &&
                                y < window.upper.y && layer.z[i] < layer.clearance;
            if (inside) volume += sphere_volume(layer.radius[i]);
        }
    }
    return volume / box_of(window);
}

struct Case {
    double grid, window;
    WindowEdge edge;
    double length = 7, width = 5;
};

class PackingMap : public ::testing::TestWithParam<Case> {};

TEST_P(PackingMap, IsTheDefinitionAtEveryNode) {
    const auto [grid, window, edge, length, width] = GetParam();
    AnalysisConfig config = unit_config(length, width);
    config.grid = grid;
    config.phi_window = window;
    config.phi_x_edge = edge;
    const Layer layer = layer_of(random_balls(120, length, width, 11), config);
    const PackingMaps maps = packing_maps(layer, config);
    ASSERT_EQ(maps.exact.ny, layer.grid.ny);
    for (int row = 0; row < maps.exact.nx; ++row) {
        for (int iy = 0; iy < maps.exact.ny; ++iy) {
            const int ix = maps.exact.first_x + row;
            EXPECT_NEAR(maps.exact.at(row, iy), exact_at(layer, config, ix, iy), 1e-13) << ix << ", " << iy;
            EXPECT_NEAR(maps.centre.at(row, iy), centre_at(layer, config, ix, iy), 1e-13) << ix << ", " << iy;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Windows, PackingMap,
                         ::testing::Values(Case{1, 3, WindowEdge::overhang}, Case{1, 3, WindowEdge::interior},
                                           Case{1, 1, WindowEdge::overhang}, Case{1, 2, WindowEdge::overhang},
                                           Case{1, 2.5, WindowEdge::interior}, Case{0.5, 3, WindowEdge::overhang},
                                           Case{0.5, 0.7, WindowEdge::overhang}, Case{1, 0.6, WindowEdge::interior},
                                           Case{1, 5, WindowEdge::overhang}));

// Neither the region nor the period is a whole number of cells: 7.3 and 5.6, 6.55 and 4.4, 2.45 and 1.49 cells.
INSTANTIATE_TEST_SUITE_P(RectangularCells, PackingMap,
                         ::testing::Values(Case{1, 3, WindowEdge::overhang, 7.3, 5.6},
                                           Case{1, 3, WindowEdge::interior, 6.55, 4.4},
                                           Case{1, 1.4, WindowEdge::overhang, 7.3, 4.4},
                                           Case{0.9, 2.7, WindowEdge::interior, 7.3, 5.6},
                                           Case{1, 1, WindowEdge::overhang, 2.45, 1.49}));

TEST(PackingNodes, InteriorDropsWindowsThatReachOut) {
    const Grid grid = {.nx = 10, .ny = 4, .spacing = 1};
    const auto count = [&](double window) { return packing_nodes(grid, window, WindowEdge::interior).count; };
    EXPECT_EQ(count(1), 10);
    EXPECT_EQ(count(0.5), 10);
    EXPECT_EQ(count(2), 8);
    EXPECT_EQ(count(3), 8);
    EXPECT_EQ(count(3.5), 6);
    EXPECT_EQ(count(10), 0);  // nodes lie half a cell beside the middle of the region
    EXPECT_EQ(packing_nodes(grid, 3, WindowEdge::interior).first, 1);
    EXPECT_EQ(packing_nodes(grid, 3, WindowEdge::overhang).count, 10);
}

TEST(PackingMapValues, WindowsWithoutSpheresAreExactlyEmpty) {
    const AnalysisConfig config = unit_config(12, 8);
    // Touching a window edge from outside, and through the period.
    const Layer layer = layer_of({{5.5, 3.5, 0.4999}, {2.1234567, 0.25, 0.5}}, config);
    const PackingMaps maps = packing_maps(layer, config);
    int empty = 0;
    for (int ix = 0; ix < 12; ++ix) {
        for (int iy = 0; iy < 8; ++iy) {
            if (exact_at(layer, config, ix, iy) > 1e-12) continue;
            EXPECT_EQ(maps.exact.at(ix, iy), 0);
            ++empty;
        }
    }
    EXPECT_GT(empty, 60);
}

TEST(PackingMapValues, CentresOnAnEdgeBelongToTheWindowAbove) {
    const AnalysisConfig config = unit_config(6, 6);
    const double share = sphere_volume(0.5) / (9 * 1.5);
    for (const double offset : {0.0, -1e-9, 1e-9}) {  // round-off must not move it
        const Layer layer = layer_of({{3 + offset, offset, 0.5}}, config);
        const Map map = packing_maps(layer, config).centre;
        EXPECT_EQ(map.at(1, 0), 0);  // [0, 3)
        EXPECT_DOUBLE_EQ(map.at(2, 0), share);
        EXPECT_DOUBLE_EQ(map.at(4, 0), share);  // [3, 6)
        EXPECT_EQ(map.at(5, 0), 0);
        EXPECT_DOUBLE_EQ(map.at(2, 5), share);  // [4, 7): holds 6, the image of 0
        EXPECT_EQ(map.at(2, 4), 0);             // [3, 6)
    }
}

}  // namespace
}  // namespace recoat
