#include "solver/output/wall_polygons.hpp"

#include <algorithm>
#include <cmath>

namespace recoat {
namespace {

/// The part of a polygon where dot(normal, p) <= bound.
Polygon cut(const Polygon& polygon, Vec3 normal, double bound) {
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        const double from = dot(normal, a) - bound, to = dot(normal, b) - bound;
        if (from <= 0) kept.push_back(a);
        if ((from < 0 && to > 0) || (from > 0 && to < 0)) kept.push_back(a + (from / (from - to)) * (b - a));
    }
    return kept;
}

/// A square about the point of a plane nearest to the middle of the space, larger than the space.
Polygon square_of(const Wall& plane, const DrawnSpace& space) {
    const Vec3 middle = 0.5 * (space.lower + space.upper), n = plane.normal;
    const Vec3 nearest = middle - dot(n, middle - plane.point) * n;
    const Vec3 axis = std::abs(n.x) < 0.8 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    Vec3 u = cross(n, axis);
    u = 1 / norm(u) * u;
    const double reach = norm(space.upper - space.lower);
    const Vec3 a = reach * u, b = reach * cross(n, u);
    return {nearest - a - b, nearest + a - b, nearest + a + b, nearest - a + b};
}

Polygon plane_polygon(const Wall& wall, const DrawnSpace& space) {
    Polygon polygon = square_of(wall, space);
    for (const Vec3 axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
        polygon = cut(polygon, axis, dot(axis, space.upper));
        polygon = cut(polygon, -axis, -dot(axis, space.lower));
    }
    return polygon;
}

std::vector<Polygon> box_polygons(const Wall& wall, const DrawnSpace& space) {
    const Vec3 a = {std::max(wall.lower.x, space.lower.x), std::max(wall.lower.y, space.lower.y),
                    std::max(wall.lower.z, space.lower.z)};
    const Vec3 b = {std::min(wall.upper.x, space.upper.x), std::min(wall.upper.y, space.upper.y),
                    std::min(wall.upper.z, space.upper.z)};
    if (!(a.x < b.x && a.y < b.y && a.z < b.z)) return {};
    return {{{a.x, a.y, a.z}, {a.x, b.y, a.z}, {b.x, b.y, a.z}, {b.x, a.y, a.z}},
            {{a.x, a.y, b.z}, {b.x, a.y, b.z}, {b.x, b.y, b.z}, {a.x, b.y, b.z}},
            {{a.x, a.y, a.z}, {b.x, a.y, a.z}, {b.x, a.y, b.z}, {a.x, a.y, b.z}},
            {{a.x, b.y, a.z}, {a.x, b.y, b.z}, {b.x, b.y, b.z}, {b.x, b.y, a.z}},
            {{a.x, a.y, a.z}, {a.x, a.y, b.z}, {a.x, b.y, b.z}, {a.x, b.y, a.z}},
            {{b.x, a.y, a.z}, {b.x, b.y, a.z}, {b.x, b.y, b.z}, {b.x, a.y, b.z}}};
}

}  // namespace

std::vector<Polygon> wall_polygons(const Wall& wall, const DrawnSpace& space) {
    if (wall.kind == WallKind::box) return box_polygons(wall, space);
    Polygon polygon = plane_polygon(wall, space);
    if (polygon.size() < 3) return {};
    return {std::move(polygon)};
}

}  // namespace recoat
