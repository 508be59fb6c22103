#include "analyzer/fields/voronoi_graph.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <tuple>
#include <utility>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <tbb/parallel_sort.h>

#include "analyzer/fields/parallel.hpp"
#include "analyzer/fields/plane_blocks.hpp"

namespace recoat {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
/// Index of the Voronoi vertex of a face in its block; npos for one that belongs to another block.
using FaceBase = CGAL::Triangulation_face_base_with_info_2<std::size_t, Kernel>;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;
using Face = Delaunay::Face_handle;
using Vector = Kernel::Vector_2;

constexpr std::size_t npos = static_cast<std::size_t>(-1);
/// Cosine below which an angle counts as a right one.
constexpr double right_angle_tolerance = 1e-6;
/// Vertices may lie this far beyond the outermost centres, by round-off [d_p].
constexpr double end_zone = 1e-3;

/// A corner of a triangle: disk and turn.
using Corner = std::pair<std::size_t, int>;

/// Edges with ends that differ by whole turns are copies of each other.
std::array<Corner, 2> canonical(Corner a, Corner b) {
    if (b < a) std::swap(a, b);
    return {Corner{a.first, 0}, Corner{b.first, b.second - a.second}};
}

/// One side of an edge whose other side belongs to another block, or to another copy of this one.
struct OpenEdge {
    std::array<Corner, 2> key;
    std::size_t vertex;
    double midpoint_gap;
    bool midpoint_inside;
};

/// What belongs to one block, numbered from 0.
struct GraphPart {
    VoronoiGraph graph;
    std::vector<OpenEdge> open;
};

/// The gap is least in the middle of the two disks, where that lies on the way, or else at an end.
VoronoiEdge edge_between(const VoronoiGraph& graph, const OpenEdge& half, std::size_t other, bool other_inside) {
    const double throat = half.midpoint_inside && other_inside
                              ? half.midpoint_gap
                              : std::min(graph.vertices[half.vertex].radius, graph.vertices[other].radius);
    return {half.vertex, other, throat};
}

/// The part of the graph that belongs to a block. CGAL breaks ties of cocircular points by their coordinates, so that
/// the triangulations of neighbouring blocks agree where both are right.
class PartBuilder {
public:
    PartBuilder(const TopView& view, const PlaneBlock& block, double x_min, double x_max)
        : view_(view), block_(block), x_min_(x_min), x_max_(x_max) {}

    GraphPart run() {
        std::vector<std::pair<Delaunay::Point, std::size_t>> points(block_.disks.size());
        for (std::size_t i = 0; i < points.size(); ++i) points[i] = {{block_.disks[i].x, block_.disks[i].y}, i};
        triangulation_.insert(points.begin(), points.end());
        if (triangulation_.dimension() < 2) return {};
        for (const Face face : triangulation_.all_face_handles()) face->info() = npos;
        for (const Face face : triangulation_.finite_face_handles()) add_vertex(face);
        for (const Face face : triangulation_.finite_face_handles()) {
            if (face->info() != npos) add_edges(face);
        }
        return std::move(part_);
    }

private:
    [[nodiscard]] Corner corner(Face face, int i) const {
        const Disk& disk = block_.disks[face->vertex(i)->info()];
        return {disk.index, disk.turn};
    }

    /// Every copy of a face, in whatever block, is measured from the same corner and so gives the same bits.
    void add_vertex(Face face) {
        const int first = lowest_corner(face);
        const auto& p = face->vertex(first)->point();
        const Vector a = face->vertex(Delaunay::ccw(first))->point() - p;
        const Vector b = face->vertex(Delaunay::cw(first))->point() - p;
        const double twice_area = a.x() * b.y() - a.y() * b.x();
        const double aa = a.squared_length(), bb = b.squared_length();
        const Vector arm((b.y() * aa - a.y() * bb) / (2 * twice_area), (a.x() * bb - b.x() * aa) / (2 * twice_area));
        const double x = p.x() + arm.x();
        if (!(x >= x_min_ - end_zone && x <= x_max_ + end_zone)) return;
        const auto [index, turn] = corner(face, first);
        const double y = view_.disks[index].y + arm.y();
        double own_turn = -std::floor(y / view_.period), wrapped = y + own_turn * view_.period;
        if (wrapped >= view_.period) {
            wrapped = 0;
            own_turn -= 1;
        }
        if (turn != own_turn || !block_.holds(x, wrapped)) return;
        face->info() = part_.graph.vertices.size();
        part_.graph.vertices.push_back({x, wrapped, std::sqrt(arm.squared_length()) - view_.disks[index].radius});
        part_.graph.is_maximum.push_back(!is_obtuse(face));
    }

    [[nodiscard]] int lowest_corner(Face face) const {
        int lowest = 0;
        for (const int i : {1, 2}) {
            if (corner(face, i) < corner(face, lowest)) lowest = i;
        }
        return lowest;
    }

    /// Cosine of the angle at a corner.
    static double cosine(Face face, int i) {
        const auto& p = face->vertex(i)->point();
        const Vector a = face->vertex(Delaunay::ccw(i))->point() - p, b = face->vertex(Delaunay::cw(i))->point() - p;
        return a * b / std::sqrt(a.squared_length() * b.squared_length());
    }

    static bool is_obtuse(Face face) {
        for (int i = 0; i < 3; ++i) {
            if (cosine(face, i) < -right_angle_tolerance) return true;
        }
        return false;
    }

    void add_edges(Face face) {
        for (int i = 0; i < 3; ++i) {
            const Face other = face->neighbor(i);
            const auto &p = face->vertex(Delaunay::ccw(i))->point(), &q = face->vertex(Delaunay::cw(i))->point();
            const OpenEdge half = {
                canonical(corner(face, Delaunay::ccw(i)), corner(face, Delaunay::cw(i))), face->info(),
                0.5 * std::sqrt((p - q).squared_length()) - view_.disks[corner(face, i).first].radius,
                cosine(face, i) > 0};
            if (other->info() == npos) {
                part_.open.push_back(half);
            } else if (face->info() < other->info()) {
                const int j = other->index(face);
                part_.graph.edges.push_back(edge_between(part_.graph, half, other->info(), cosine(other, j) > 0));
            }
        }
    }

    const TopView& view_;
    const PlaneBlock& block_;
    double x_min_, x_max_;
    Delaunay triangulation_;
    GraphPart part_;
};

/// Edges between parts: the two halves are at different copies. One half alone leads out of the data.
void match_open_edges(std::vector<OpenEdge>& open, VoronoiGraph& graph) {
    tbb::parallel_sort(open.begin(), open.end(), [](const OpenEdge& a, const OpenEdge& b) {
        return std::tie(a.key, a.vertex) < std::tie(b.key, b.vertex);
    });
    for (std::size_t k = 1; k < open.size(); ++k) {
        if (open[k].key != open[k - 1].key) continue;
        graph.edges.push_back(edge_between(graph, open[k - 1], open[k].vertex, open[k].midpoint_inside));
    }
}

VoronoiGraph joined(const std::vector<GraphPart>& parts) {
    VoronoiGraph graph;
    std::vector<OpenEdge> open;
    for (const GraphPart& part : parts) {
        const std::size_t offset = graph.vertices.size();
        graph.vertices.insert(graph.vertices.end(), part.graph.vertices.begin(), part.graph.vertices.end());
        graph.is_maximum.insert(graph.is_maximum.end(), part.graph.is_maximum.begin(), part.graph.is_maximum.end());
        for (const VoronoiEdge& edge : part.graph.edges) {
            graph.edges.push_back({edge.first + offset, edge.second + offset, edge.throat});
        }
        for (const OpenEdge& half : part.open) {
            open.push_back(half);
            open.back().vertex += offset;
        }
    }
    match_open_edges(open, graph);
    return graph;
}

}  // namespace

VoronoiGraph voronoi_graph(const TopView& view) {
    if (view.disks.empty()) return {};
    const auto [first, last] = std::ranges::minmax(view.disks, {}, &Disk::x);
    const std::vector<PlaneBlock> blocks = plane_blocks(view, farthest_from_centres(view));
    std::vector<GraphPart> parts(blocks.size());
    for_each_in_parallel(blocks.size(), [&, low = first.x, high = last.x](std::size_t b) {
        parts[b] = PartBuilder(view, blocks[b], low, high).run();
    });
    return joined(parts);
}

}  // namespace recoat
