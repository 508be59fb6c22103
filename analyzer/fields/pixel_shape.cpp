#include "analyzer/fields/pixel_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/min_quadrilateral_2.h>

namespace recoat {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Polygon = CGAL::Polygon_2<Kernel>;

/// Half the difference of the principal moments must exceed this share of their mean for an axis to stand out.
constexpr double smallest_anisotropy = 1e-6;

void set_moments(std::span<const GridCell> cells, Sides side, PixelShape& shape) {
    const auto count = static_cast<double>(cells.size());
    double mean_x = 0, mean_y = 0;
    for (const GridCell cell : cells) {
        mean_x += cell.ix / count;
        mean_y += cell.iy / count;
    }
    constexpr double own = 1.0 / 12;
    double xx = own * side.x * side.x, yy = own * side.y * side.y, xy = 0;
    for (const GridCell cell : cells) {
        const double x = (cell.ix - mean_x) * side.x, y = (cell.iy - mean_y) * side.y;
        xx += x * x / count;
        yy += y * y / count;
        xy += x * y / count;
    }
    const double mean = 0.5 * (xx + yy), half_difference = 0.5 * std::hypot(xx - yy, 2 * xy);
    shape.elongation = std::sqrt((mean + half_difference) / (mean - half_difference));
    if (half_difference <= smallest_anisotropy * mean) return;
    shape.angle = std::abs(0.5 * std::atan2(2 * xy, xx - yy)) * 180 / std::numbers::pi;
}

/// Corners of the first and the last cell of every column: all that the hull can touch. In cells, hence exact.
std::vector<Point> outer_corners(std::span<const GridCell> cells, int first, int last) {
    std::vector<std::pair<int, int>> ends(static_cast<std::size_t>(last - first) + 1, {1, 0});
    for (const GridCell cell : cells) {
        auto& [low, high] = ends[static_cast<std::size_t>(cell.ix - first)];
        if (low > high) low = high = cell.iy;
        low = std::min(low, cell.iy);
        high = std::max(high, cell.iy);
    }
    std::vector<Point> corners;
    for (int column = first; column <= last; ++column) {
        const auto [low, high] = ends[static_cast<std::size_t>(column - first)];
        if (low > high) continue;
        for (const int x : {column, column + 1}) {
            corners.emplace_back(x, low);
            corners.emplace_back(x, high + 1);
        }
    }
    return corners;
}

double distance(const Point& a, const Point& b) { return std::sqrt(CGAL::squared_distance(a, b)); }

void set_hull(const std::vector<Point>& corners, Sides side, PixelShape& shape) {
    std::vector<Point> round_cells;
    CGAL::convex_hull_2(corners.begin(), corners.end(), std::back_inserter(round_cells));
    // Stretching along an axis keeps a hull a hull.
    Polygon hull;
    for (const Point& corner : round_cells) hull.push_back(Point(corner.x() * side.x, corner.y() * side.y));
    shape.hull_area = hull.area();
    for (auto edge = hull.edges_begin(); edge != hull.edges_end(); ++edge) {
        shape.hull_perimeter += distance(edge->source(), edge->target());
    }
    std::vector<Point> rectangle;
    CGAL::min_rectangle_2(hull.vertices_begin(), hull.vertices_end(), std::back_inserter(rectangle));
    const double one = distance(rectangle[0], rectangle[1]), other = distance(rectangle[1], rectangle[2]);
    shape.rect_long = std::max(one, other);
    shape.rect_short = std::min(one, other);
}

}  // namespace

PixelShape pixel_shape(std::span<const GridCell> cells, Sides cell) {
    PixelShape shape;
    set_moments(cells, cell, shape);
    const auto [left, right] = std::ranges::minmax(cells, {}, &GridCell::ix);
    const auto [bottom, top] = std::ranges::minmax(cells, {}, &GridCell::iy);
    shape.extent_x = (right.ix - left.ix + 1) * cell.x;
    shape.extent_y = (top.iy - bottom.iy + 1) * cell.y;
    set_hull(outer_corners(cells, left.ix, right.ix), cell, shape);
    return shape;
}

}  // namespace recoat
