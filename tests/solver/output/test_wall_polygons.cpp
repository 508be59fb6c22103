#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "solver/output/wall_polygons.hpp"

namespace recoat {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
const DrawnSpace space{{-1, 0, 0}, {3, 2, 5}};

Wall plane(Vec3 point, Vec3 normal) {
    Wall wall;
    wall.point = point;
    wall.normal = 1 / norm(normal) * normal;
    return wall;
}

Wall box(Vec3 lower, Vec3 upper) {
    Wall wall;
    wall.kind = WallKind::box;
    wall.lower = lower;
    wall.upper = upper;
    return wall;
}

/// Twice the area of a plane polygon, as a vector along its normal.
Vec3 double_area(const Polygon& polygon) {
    Vec3 sum;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        sum += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
    return sum;
}

TEST(WallPolygons, APlaneFillsTheSpace) {
    const std::vector<Polygon> polygons = wall_polygons(plane({100, -7, 1}, {0, 0, 1}), space);
    ASSERT_EQ(polygons.size(), 1U);
    EXPECT_NEAR(norm(double_area(polygons[0])), 2 * 4 * 2, 1e-12);
    for (const Vec3 corner : polygons[0]) EXPECT_NEAR(corner.z, 1, 1e-12);
}

TEST(WallPolygons, APlaneThatPassesBySpaceIsNotDrawn) {
    EXPECT_TRUE(wall_polygons(plane({0, 0, 6}, {0, 0, 1}), space).empty());
    EXPECT_TRUE(wall_polygons(plane({9, 9, 9}, {1, 1, 1}), space).empty());
}

/// The hexagon through the middle of a cube, and a corner cut off.
TEST(WallPolygons, ATiltedPlaneIsCutAtEveryFace) {
    const DrawnSpace cube{{0, 0, 0}, {1, 1, 1}};
    const std::vector<Polygon> hexagon = wall_polygons(plane({0.5, 0.5, 0.5}, {1, 1, 1}), cube);
    ASSERT_EQ(hexagon.size(), 1U);
    EXPECT_EQ(hexagon[0].size(), 6U);
    EXPECT_NEAR(norm(double_area(hexagon[0])), 2 * 3 * std::sqrt(3.0) / 4, 1e-12);
    const std::vector<Polygon> corner = wall_polygons(plane({0.5, 0, 0}, {-1, -1, -1}), cube);
    ASSERT_EQ(corner.size(), 1U);
    EXPECT_EQ(corner[0].size(), 3U);
    EXPECT_NEAR(norm(double_area(corner[0])), 2 * std::sqrt(3.0) / 2 * 0.5 * 0.5, 1e-12);
}

TEST(WallPolygons, TheFacesOfABoxCloseItAndPointOutwards) {
    const std::vector<Polygon> faces = wall_polygons(box({0, -infinity, 1.5}, {2, infinity, infinity}), space);
    ASSERT_EQ(faces.size(), 6U);
    double volume = 0;
    Vec3 sum;
    for (const Polygon& face : faces) {
        sum += double_area(face);
        volume += dot(face[0], double_area(face)) / 6;
    }
    EXPECT_NEAR(norm(sum), 0, 1e-12);
    EXPECT_NEAR(volume, 2 * 2 * 3.5, 1e-12);
    EXPECT_TRUE(wall_polygons(box({4, 0, 0}, {5, 1, 1}), space).empty());
}

}  // namespace
}  // namespace recoat
