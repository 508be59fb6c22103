#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "solver/output/packing_density.hpp"

namespace recoat {
namespace {

// A face-centred cubic bed of 16 planes; metrics of the literature give 0.7519 for whole spheres with z <= 0.9 z_max.
TEST(PackingDensity, FaceCentredCubicBed) {
    const int n = 4, planes = 16;
    const double spacing = std::sqrt(0.5);  // of the planes; the spheres of a plane touch on a square lattice of side 1
    ParticleTable table;
    for (int k = 0; k < planes; ++k) {
        for (int i = 0; i < n * n; ++i) {
            const double shift = k % 2 == 0 ? 0 : 0.5;
            table.position.push_back({i % n + shift, i / n + shift, 0.5 + k * spacing});
        }
    }
    table.radius.assign(table.position.size(), 0.5);
    const double top = 1 + (planes - 1) * spacing;
    int below = 0;
    for (int k = 0; k < planes; ++k) below += 0.5 + k * spacing <= 0.9 * top ? 1 : 0;
    EXPECT_NEAR(bed_packing_density(table, n * n), below * std::numbers::pi / 6 / (0.9 * top), 1e-12);
    EXPECT_NEAR(bed_packing_density(table, n * n), 0.7519, 5e-5);
}

TEST(PackingDensity, BottomOfTheBedCounts) {
    ParticleTable table;
    table.position = {{0, 0, 10}, {0, 0, 10.2}};
    table.radius = {0.5, 0.5};
    // z_max = 10.7, z_min = 9.5: 0.9 z_max = 9.63 lies below both centres
    EXPECT_EQ(bed_packing_density(table, 1), 0);
    EXPECT_EQ(bed_packing_density({}, 1), 0);
}

}  // namespace
}  // namespace recoat
