#include <limits>

#include <gtest/gtest.h>

#include "solver/scene/join_boxes.hpp"

namespace recoat {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

Wall box(const std::string& name, Vec3 lower, Vec3 upper) {
    Wall wall;
    wall.name = name;
    wall.kind = WallKind::box;
    wall.lower = lower;
    wall.upper = upper;
    return wall;
}

const Wall left = box("left", {-inf, -inf, -1}, {0, inf, 0}), right = box("right", {0, -inf, -1}, {inf, inf, 0});

TEST(JoinBoxes, TwoHalvesOfAFloorAreOneWall) {
    const std::vector<Wall> walls = join_boxes({left, right}, {});
    ASSERT_EQ(walls.size(), 1U);
    EXPECT_EQ(walls[0].name, "left and right");
    EXPECT_EQ(walls[0].lower, (Vec3{-inf, -inf, -1}));
    EXPECT_EQ(walls[0].upper, (Vec3{inf, inf, 0}));
}

TEST(JoinBoxes, TilesBecomeOneHoweverTheyAreOrdered) {
    std::vector<Wall> tiles;
    for (const int i : {3, 0, 2, 1}) tiles.push_back(box(std::to_string(i), {1.0 * i, 0, 0}, {i + 1.0, 1, 1}));
    const std::vector<Wall> walls = join_boxes(tiles, {});
    ASSERT_EQ(walls.size(), 1U);
    EXPECT_EQ(walls[0].lower, (Vec3{0, 0, 0}));
    EXPECT_EQ(walls[0].upper, (Vec3{4, 1, 1}));
}

TEST(JoinBoxes, AFloorOfTilesInRowsIsOneWall) {
    for (const bool by_rows : {true, false}) {
        std::vector<Wall> tiles;
        for (int k = 0; k < 9; ++k) {
            const double x = by_rows ? k % 3 : k / 3, y = by_rows ? k / 3 : k % 3;
            tiles.push_back(box(std::to_string(k), {x, y, -1}, {x + 1, y + 1, 0}));
        }
        const std::vector<Wall> walls = join_boxes(tiles, {});
        ASSERT_EQ(walls.size(), 1U);
        EXPECT_EQ(walls[0].lower, (Vec3{0, 0, -1}));
        EXPECT_EQ(walls[0].upper, (Vec3{3, 3, 0}));
    }
}

TEST(JoinBoxes, WhatIsNoBoxTogetherStaysApart) {
    EXPECT_EQ(join_boxes({left, box("step", {0, -inf, -1}, {inf, inf, 0.1})}, {}).size(), 2U);  // a step
    EXPECT_EQ(join_boxes({left, box("gap", {0.1, -inf, -1}, {inf, inf, 0})}, {}).size(), 2U);   // a gap
    EXPECT_EQ(join_boxes({left, box("short", {0, -1, -1}, {inf, 1, 0})}, {}).size(), 2U);       // another width
}

TEST(JoinBoxes, WallsThatMoveOrGoAreLeftAlone) {
    Wall moving = right;
    moving.velocity = {0, 0, 1};
    EXPECT_EQ(join_boxes({left, moving}, {}).size(), 2U);
    EXPECT_EQ(join_boxes({left, right}, {{"remove", "remove", {{{"right"}, {}, 0, {}}}}}).size(), 2U);
    EXPECT_EQ(join_boxes({left, right}, {{"move", "move", {{{}, {{"left", {1, 0, 0}}}, 5, {}}}}}).size(), 2U);
}

}  // namespace
}  // namespace recoat
