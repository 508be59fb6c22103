#include <random>
#include <set>

#include <gtest/gtest.h>

#include "solver/engine/cells.hpp"
#include "solver/execution/openmp.hpp"

namespace recoat {
namespace {

/// A grid over `rows`.
Cells grid(const std::vector<Row>& rows, double side, double y_min, double y_period) {
    OpenMP space(1);
    return make_cells(extent_of(space, rows.data(), rows.size()), side, y_min, y_period);
}

std::vector<Row> scattered(std::size_t count, double length, unsigned seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<Row> rows(count);
    for (Row& row : rows) row = {length * unit(random), length * unit(random), length * unit(random), 1};
    return rows;
}

TEST(Cells, EveryPositionHasACellAndCellsAreAtLeastTheSide) {
    const auto rows = scattered(500, 10, 1);
    const double side = 0.9;
    const Cells cells = grid(rows, side, 0, 0);
    for (const Row& p : rows) {
        EXPECT_GE(cells.key(p), 0);
        EXPECT_LT(cells.key(p), cells.count());
    }
    // Positions two cells apart are at least a side apart, on every axis.
    for (const Row& p : rows)
        for (const Row& q : rows)
            for (int axis = 0; axis < 3; ++axis) {
                if (std::abs(cells.coordinate(axis, p) - cells.coordinate(axis, q)) < 2) continue;
                const double a = axis == 0 ? p.x - q.x : axis == 1 ? p.y - q.y : p.z - q.z;
                ASSERT_GE(std::fabs(a), side);
            }
}

TEST(Cells, KeysAreDifferentForDifferentCells) {
    const Cells cells = grid(scattered(100, 10, 2), 1, 0, 10);
    std::set<std::int64_t> keys;
    for (std::int64_t x = 0; x < cells.along[0]; ++x)
        for (std::int64_t y = 0; y < cells.along[1]; ++y)
            for (std::int64_t z = 0; z < cells.along[2]; ++z) keys.insert(cells.key(x, y, z));
    EXPECT_EQ(static_cast<std::int64_t>(keys.size()), cells.count());
    EXPECT_EQ(*keys.begin(), 0);
    EXPECT_EQ(*keys.rbegin(), cells.count() - 1);
}

TEST(Cells, ThePeriodSetsTheGridInY) {
    const Cells cells = grid(scattered(10, 3, 3), 1, -1, 7.5);
    EXPECT_TRUE(cells.periodic);
    EXPECT_EQ(cells.along[1], 7);
    EXPECT_EQ(cells.coordinate(1, {0, -1, 0, 1}), 0);
    EXPECT_EQ(cells.coordinate(1, {0, 6.4999, 0, 1}), 6);
}

TEST(Cells, GrowWhereParticlesAreFew) {
    std::vector<Row> rows = scattered(20, 1, 4);
    rows.push_back({1e6, 1e6, 1e6, 1});
    EXPECT_LT(grid(rows, 1e-3, 0, 0).count(), 8 * 21 + 1001);
    // Far apart along one axis only, where cells cannot grow along the others.
    const std::vector<Row> line = {{0, 0, 0, 1}, {1e12, 0, 0, 1}, {1e12, 1e-3, 0, 1}};
    EXPECT_LT(grid(line, 1e-3, 0, 0).count(), 8 * 3 + 1001);
}

TEST(Cells, NotANumberLiesInACellToo) {
    const Cells cells = grid(scattered(10, 3, 5), 1, 0, 0);
    EXPECT_EQ(cells.coordinate(0, {std::nan(""), 0, 0, 1}), 0);
    EXPECT_EQ(cells.coordinate(0, {1e300, 0, 0, 1}), cells.along[0] - 1);
    EXPECT_EQ(cells.coordinate(0, {-1e300, 0, 0, 1}), 0);
}

TEST(Cells, OnePositionOrNoneMakeOneCell) {
    EXPECT_EQ(grid({}, 1, 0, 0).count(), 1);
    EXPECT_EQ(grid({{5, 5, 5, 1}}, 1, 0, 0).count(), 1);
    EXPECT_EQ(grid({{5, 5, 5, 1}}, 1, 0, 0).key({5, 5, 5, 1}), 0);
}

}  // namespace
}  // namespace recoat
