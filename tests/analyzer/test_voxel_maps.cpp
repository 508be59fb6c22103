#include <cmath>

#include <gtest/gtest.h>

#include "analyzer/fields/height_map.hpp"
#include "analyzer/fields/packing_map.hpp"
#include "analyzer/fields/voxel_maps.hpp"
#include "analyzer/metrics/packing.hpp"
#include "tests/analyzer/support.hpp"

namespace recoat {
namespace {

using testing::Ball;
using testing::fitted;
using testing::layer_of;
using testing::random_balls;
using testing::unit_config;

/// The definition as it stands: is the centre of this voxel in any sphere?
bool is_solid(const Layer& layer, double x, double y, double z) {
    for (std::size_t i = 0; i < layer.size(); ++i) {
        const double dx = x - layer.x[i], dy = std::remainder(y - layer.y[i], layer.width), dz = z - layer.z[i];
        if (dx * dx + dy * dy + dz * dz <= layer.radius[i] * layer.radius[i]) return true;
    }
    return false;
}

/// Indices k of the voxels with their centre in [low, high).
std::vector<int> centres_in(double low, double high, double n) {
    std::vector<int> indices;
    for (int k = static_cast<int>(std::floor(low * n)) - 1; k <= high * n + 1; ++k) {
        const double centre = (k + 0.5) / n;
        if (centre >= low - 1e-9 && centre < high - 1e-9) indices.push_back(k);
    }
    return indices;
}

struct Case {
    double grid, phi_window, height_window;
    int n;
    double length = 3, width = 3;
};

class VoxelMap : public ::testing::TestWithParam<Case> {};

TEST_P(VoxelMap, IsTheDefinitionAtEveryNode) {
    const auto [grid, phi_window, height_window, n, length, width] = GetParam();
    AnalysisConfig config = unit_config(length, width);
    config.grid = grid;
    config.phi_window = phi_window;
    config.height_window = height_window;
    const Layer layer = layer_of(random_balls(14, length, width, 21), config);
    const VoxelMaps maps = voxel_maps(layer, config, n);
    const double stretch_x = fitted(length, grid) / grid, stretch_y = fitted(width, grid) / grid;
    const double per_x = 1 / fitted(length, 1.0 / n), per_y = 1 / fitted(width, 1.0 / n);
    const auto along_x = [&](double x, double window) {
        return centres_in(x - window / 2 * stretch_x, x + window / 2 * stretch_x, per_x);
    };
    const auto along_y = [&](double y, double window) {
        return centres_in(y - window / 2 * stretch_y, y + window / 2 * stretch_y, per_y);
    };
    for (int ix = 0; ix < layer.grid.nx; ++ix) {
        for (int iy = 0; iy < layer.grid.ny; ++iy) {
            const double x = (ix + 0.5) * grid * stretch_x, y = (iy + 0.5) * grid * stretch_y;
            int solid = 0, voxels = 0;
            for (const int i : along_x(x, phi_window)) {
                for (const int j : along_y(y, phi_window)) {
                    for (const int k : centres_in(0, layer.clearance, n)) {
                        solid += is_solid(layer, (i + 0.5) / per_x, (j + 0.5) / per_y, (k + 0.5) / n);
                        ++voxels;
                    }
                }
            }
            EXPECT_DOUBLE_EQ(maps.phi.at(ix, iy), static_cast<double>(solid) / voxels) << ix << ", " << iy;
            double top = 0;
            for (const int i : along_x(x, height_window)) {
                for (const int j : along_y(y, height_window)) {
                    for (const int k : centres_in(0, 3, n)) {
                        if (is_solid(layer, (i + 0.5) / per_x, (j + 0.5) / per_y, (k + 0.5) / n))
                            top = std::max(top, (k + 1.0) / n);
                    }
                }
            }
            EXPECT_DOUBLE_EQ(maps.height.at(ix, iy), top) << ix << ", " << iy;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Windows, VoxelMap,
                         ::testing::Values(Case{1, 3, 1, 4}, Case{1, 2, 1, 5}, Case{1, 3, 1, 7}, Case{0.5, 1.5, 0.5, 6},
                                           Case{1, 2.5, 1.5, 4}, Case{1, 1, 1, 10}));

// Voxels that fit the period, but not the windows.
INSTANTIATE_TEST_SUITE_P(RectangularVoxels, VoxelMap,
                         ::testing::Values(Case{1, 3, 1, 4, 3.3, 2.6}, Case{1, 2, 1, 7, 2.45, 3.37},
                                           Case{0.9, 1.8, 0.9, 5, 3.25, 3.37}));

TEST(VoxelMaps, ConvergeToTheExactOnes) {
    const AnalysisConfig config = unit_config(8, 8);
    // Spheres that do not overlap: the union of the voxels is then the sum of the spheres.
    std::vector<Ball> balls;
    for (int i = -2; i < 8; ++i) {
        for (int j = 0; j < 7; ++j) balls.push_back({1.13 * i + 0.31, 1.13 * j + 0.05 * i, 0.5 + 0.05 * (i % 3)});
    }
    const Layer layer = layer_of(balls, config);
    const Map phi = packing_maps(layer, config).exact, height = height_map(layer, config);
    double last = 1;
    for (const int n : {5, 10, 20, 40}) {
        const VoxelMaps maps = voxel_maps(layer, config, n);
        const MapError error = map_error(maps.phi, phi);
        EXPECT_LT(error.rms, 0.6 * last);
        EXPECT_LT(error.max, 0.8 / (n * n));
        last = error.rms;
        // A voxel's top face is at most half a side above the sphere.
        for (std::size_t k = 0; k < height.values.size(); ++k) {
            EXPECT_LE(maps.height.values[k], height.values[k] + 0.5 / n + 1e-12);
        }
    }
}

TEST(VoxelMaps, ReachAcrossManySlabs) {
    // 30 d_p at 20 voxels are five slabs of the tree; a sphere on each boundary between two.
    const AnalysisConfig config = unit_config(30, 3);
    std::vector<Ball> balls;
    for (int s = 0; s < 5; ++s) balls.push_back({6.4 * s, 1.5});
    const Layer layer = layer_of(balls, config);
    const MapError error = map_error(voxel_maps(layer, config, 20).phi, packing_maps(layer, config).exact);
    EXPECT_LT(error.max, 5e-4);
}

TEST(MapError, IsTheLargestAndTheRootMeanSquare) {
    Map a(0, 1, 2), b(0, 1, 2);
    a.values = {1, 2};
    b.values = {1.3, 1.6};
    EXPECT_DOUBLE_EQ(map_error(a, b).max, 0.4);
    EXPECT_DOUBLE_EQ(map_error(a, b).rms, std::sqrt(0.125));
    EXPECT_THROW((void)map_error(a, Map(0, 1, 3)), std::invalid_argument);
}

}  // namespace
}  // namespace recoat
