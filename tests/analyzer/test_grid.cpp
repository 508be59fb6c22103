#include <gtest/gtest.h>

#include "analyzer/fields/grid.hpp"
#include "analyzer/fields/voxel_lattice.hpp"

namespace recoat {
namespace {

TEST(Division, IsTheNearestThatFits) {
    EXPECT_EQ(divide(10.2941).count, 10);
    EXPECT_NEAR(divide(10.2941).stretch, 1.02941, 1e-15);
    EXPECT_EQ(divide(10.7).count, 11);
    EXPECT_NEAR(divide(10.7).stretch, 10.7 / 11, 1e-15);
    EXPECT_EQ(divide(0.2).count, 1);
    EXPECT_NEAR(divide(0.2).stretch, 0.2, 1e-15);
}

TEST(Division, RoundOffStretchesNothing) {
    for (const double sides : {1.0, 12.0 + 1e-7, 390.0 - 1e-10, 0.1 * 3 / 0.3}) EXPECT_EQ(divide(sides).stretch, 1);
}

TEST(Grid, CellsFillRegionAndPeriod) {
    const Grid grid = Grid::over(7.3, 10.2941, 1);
    EXPECT_EQ(grid.nx, 7);
    EXPECT_EQ(grid.ny, 10);
    EXPECT_NEAR(grid.cell().x * grid.nx, 7.3, 1e-12);
    EXPECT_NEAR(grid.cell().y * grid.ny, 10.2941, 1e-12);
    EXPECT_NEAR(grid.stretched(3).y, 3 * 1.02941, 1e-12);
    EXPECT_NEAR(grid.node_x(3), 3.65, 1e-12);
    EXPECT_NEAR(grid.node_y(9), 9.5 * 1.02941, 1e-12);
    const Grid square = Grid::over(8, 6, 0.5);
    EXPECT_EQ(square.nx, 16);
    EXPECT_EQ(square.cell().x, 0.5);
    EXPECT_EQ(square.cell().area(), 0.25);
}

TEST(VoxelLattice, FitsRegionAndPeriod) {
    const VoxelLattice voxels(7.3, 10.2941, 10);
    EXPECT_EQ(voxels.rows, 73);
    EXPECT_EQ(voxels.per_x, 10);
    EXPECT_EQ(voxels.columns, 103);
    EXPECT_NEAR(103 / voxels.per_y, 10.2941, 1e-12);
    EXPECT_EQ(voxels.per_z, 10);
}

}  // namespace
}  // namespace recoat
