#include "analyzer/fields/tangent_circles.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include <CGAL/Apollonius_graph_2.h>
#include <CGAL/Apollonius_graph_filtered_traits_2.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include "analyzer/fields/parallel.hpp"
#include "analyzer/fields/plane_blocks.hpp"

namespace recoat {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Traits = CGAL::Apollonius_graph_filtered_traits_2<Kernel>;
using Graph = CGAL::Apollonius_graph_2<Traits>;

/// Sine of an angle between contacts below which three of them still count as all round.
constexpr double right_angle_tolerance = 1e-6;
/// Circles this far beyond a block are looked at too, lest one on its end is missed by round-off [d_p].
constexpr double end_zone = 1e-3;

/// Whether the directions from the circle to the disks, counter-clockwise, follow each other by at most half a turn.
bool all_round(const Circle& circle, const std::array<Disk, 3>& disks) {
    double largest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Disk &a = disks[k], &b = disks[(k + 1) % 3];
        const double cross = (a.x - circle.x) * (b.y - circle.y) - (a.y - circle.y) * (b.x - circle.x);
        const double lengths = (circle.radius + a.radius) * (circle.radius + b.radius);
        if (cross < -right_angle_tolerance * lengths) return false;
        largest = std::max(largest, cross / lengths);
    }
    // Three disks in one direction, from very far away, are not all round.
    return largest > 3 * right_angle_tolerance;
}

/// Real roots of a s^2 + 2 b s + c.
std::vector<double> roots(double a, double b, double c) {
    const double discriminant = b * b - a * c;
    if (discriminant < 0) return {};
    const double q = -(b + std::copysign(std::sqrt(discriminant), b));
    std::vector<double> result;
    if (a != 0) result.push_back(q / a);
    if (q != 0) result.push_back(c / q);
    return result;
}

bool overlaps_any(const Circle& circle, const std::vector<Disk>& disks) {
    return std::ranges::any_of(disks, [&](const Disk& disk) {
        return std::hypot(disk.x - circle.x, disk.y - circle.y) < disk.radius + circle.radius - coincidence_tolerance;
    });
}

}  // namespace

std::vector<Circle> circles_between(const std::array<Disk, 3>& disks) {
    // With s = R + r0: |p| = s and |p - p_i| = s + r_i - r0, so p is linear in s.
    const Disk& o = disks[0];
    const double x1 = disks[1].x - o.x, y1 = disks[1].y - o.y, d1 = disks[1].radius - o.radius;
    const double x2 = disks[2].x - o.x, y2 = disks[2].y - o.y, d2 = disks[2].radius - o.radius;
    const double det = x1 * y2 - x2 * y1;
    if (det == 0) return {};
    const double k1 = 0.5 * (x1 * x1 + y1 * y1 - d1 * d1), k2 = 0.5 * (x2 * x2 + y2 * y2 - d2 * d2);
    const double ax = (k1 * y2 - k2 * y1) / det, bx = (d2 * y1 - d1 * y2) / det;
    const double ay = (k2 * x1 - k1 * x2) / det, by = (d1 * x2 - d2 * x1) / det;
    std::vector<Circle> circles;
    for (const double s : roots(bx * bx + by * by - 1, ax * bx + ay * by, ax * ax + ay * ay)) {
        const Circle circle = {o.x + ax + bx * s, o.y + ay + by * s, s - o.radius};
        const bool outside = circle.radius > 0 && all_round(circle, disks);
        if (outside) circles.push_back(circle);
    }
    return circles;
}

namespace {

/// The diagram of a block. Disks that come one near the other are each found from the one before.
Graph diagram(const std::vector<Disk>& disks) {
    std::vector<std::size_t> order(disks.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::vector<Kernel::Point_2> centres;
    centres.reserve(disks.size());
    for (const Disk& disk : disks) centres.emplace_back(disk.x, disk.y);
    using Places = CGAL::Pointer_property_map<Kernel::Point_2>::type;
    CGAL::spatial_sort(order.begin(), order.end(),
                       CGAL::Spatial_sort_traits_adapter_2<Kernel, Places>(CGAL::make_property_map(centres)));
    Graph graph;
    Graph::Vertex_handle near;
    for (const std::size_t i : order) {
        const Graph::Vertex_handle added = graph.insert({centres[i], disks[i].radius}, near);
        if (added != Graph::Vertex_handle()) near = added;
    }
    return graph;
}

/// The disks of a face, counter-clockwise, from the first in the plane on. CGAL begins where its memory happens to lie.
template <class Face>
std::array<Disk, 3> touched_by(const Face& face) {
    std::array<Disk, 3> disks;
    for (int k = 0; k < 3; ++k) {
        const auto& site = face->vertex(k)->site();
        disks[k] = {site.point().x(), site.point().y(), site.weight(), 0, 0};
    }
    const auto place = [](const Disk& disk) { return std::pair(disk.x, disk.y); };
    std::rotate(disks.begin(), std::ranges::min_element(disks, {}, place), disks.end());
    return disks;
}

/// Circles whose centre belongs to a block, or lies just beyond, in an order of their own.
std::vector<Circle> circles_of(const PlaneBlock& block, double period) {
    const Graph graph = diagram(block.disks);
    if (graph.dimension() < 2) return {};
    std::vector<Circle> result;
    for (auto face = graph.finite_faces_begin(); face != graph.finite_faces_end(); ++face) {
        const std::vector<Circle> circles = circles_between(touched_by(face));
        for (Circle circle : circles) {
            if (circle.x < block.x_begin - end_zone || circle.x > block.x_end + end_zone ||
                circle.y < block.y_begin - end_zone || circle.y > block.y_end + end_zone)
                continue;
            // The face stands for one circle only.
            if (circles.size() > 1 && overlaps_any(circle, block.disks)) continue;
            circle.y -= period * std::floor(circle.y / period);
            result.push_back(circle);
        }
    }
    std::ranges::sort(result, {}, [](const Circle& circle) { return std::tuple(circle.x, circle.y, circle.radius); });
    return result;
}

}  // namespace

std::vector<Circle> tangent_circles(const TopView& view) {
    if (view.disks.empty()) return {};
    const auto [smallest, largest] = std::ranges::minmax(view.disks, {}, &Disk::radius);
    const double margin = farthest_from_centres(view) + largest.radius - smallest.radius;
    const std::vector<PlaneBlock> blocks = plane_blocks(view, margin);
    std::vector<std::vector<Circle>> parts(blocks.size());
    for_each_in_parallel(blocks.size(), [&](std::size_t b) { parts[b] = circles_of(blocks[b], view.period); });
    std::vector<Circle> result;
    for (const std::vector<Circle>& part : parts) result.insert(result.end(), part.begin(), part.end());
    return result;
}

}  // namespace recoat
