#include "analyzer/fields/voronoi_graph.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

namespace recoat {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
/// Index of the Voronoi vertex of a face; npos for one that another copy of the face stands for.
using FaceBase = CGAL::Triangulation_face_base_with_info_2<std::size_t, Kernel>;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;
using Face = Delaunay::Face_handle;
using Vector = Kernel::Vector_2;

constexpr std::size_t npos = static_cast<std::size_t>(-1);
/// Cosine below which an angle counts as a right one.
constexpr double right_angle_tolerance = 1e-6;
/// Faces this far beyond the period are looked at too, lest one on its end is missed by round-off [d_p].
constexpr double end_zone = 1e-3;

/// A corner of a triangle: disk and turn.
using Corner = std::pair<std::size_t, int>;

/// Triangles, or edges, with corners that differ by whole turns are copies of each other.
template <std::size_t N>
std::array<Corner, N> canonical(std::array<Corner, N> corners) {
    std::ranges::sort(corners);
    const int turn = corners[0].second;
    for (Corner& corner : corners) corner.second -= turn;
    return corners;
}

class GraphBuilder {
public:
    explicit GraphBuilder(const TopView& view) : view_(view), disks_(view.tiled(0.5 * view.period + 2 * end_zone)) {}

    VoronoiGraph run() {
        std::vector<std::pair<Delaunay::Point, std::size_t>> points(disks_.size());
        for (std::size_t i = 0; i < disks_.size(); ++i) points[i] = {{disks_[i].x, disks_[i].y}, i};
        triangulation_.insert(points.begin(), points.end());
        if (triangulation_.dimension() < 2) return {};
        for (const Face face : triangulation_.all_face_handles()) face->info() = npos;
        for (const Face face : triangulation_.finite_face_handles()) add_vertex(face);
        for (const Face face : triangulation_.finite_face_handles()) {
            if (face->info() != npos) add_edges(face);
        }
        match_open_edges();
        return std::move(graph_);
    }

private:
    struct OpenEdge {
        std::array<Corner, 2> key;
        std::size_t vertex;
        double midpoint_gap;
        bool midpoint_inside;
    };

    [[nodiscard]] Corner corner(Face face, int i) const {
        const Disk& disk = disks_[face->vertex(i)->info()];
        return {disk.index, disk.turn};
    }

    void add_vertex(Face face) {
        const auto& p = face->vertex(0)->point();
        const Vector a = face->vertex(1)->point() - p, b = face->vertex(2)->point() - p;
        const double twice_area = a.x() * b.y() - a.y() * b.x();
        const double aa = a.squared_length(), bb = b.squared_length();
        const Vector arm((b.y() * aa - a.y() * bb) / (2 * twice_area), (a.x() * bb - b.x() * aa) / (2 * twice_area));
        double y = p.y() + arm.y();
        if (!(y >= -end_zone && y <= view_.period + end_zone)) return;
        if (y < end_zone || y > view_.period - end_zone) {
            const auto key = canonical<3>({corner(face, 0), corner(face, 1), corner(face, 2)});
            if (!seen_.insert(key).second) return;
            y -= view_.period * std::floor(y / view_.period);
        }
        const double radius = view_.disks[corner(face, 0).first].radius;
        face->info() = graph_.vertices.size();
        graph_.vertices.push_back({p.x() + arm.x(), y, std::sqrt(arm.squared_length()) - radius});
        graph_.is_maximum.push_back(!is_obtuse(face));
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
                canonical<2>({corner(face, Delaunay::ccw(i)), corner(face, Delaunay::cw(i))}), face->info(),
                0.5 * std::sqrt((p - q).squared_length()) - view_.disks[corner(face, i).first].radius,
                cosine(face, i) > 0};
            if (other->info() == npos) {
                open_.push_back(half);
            } else if (face->info() < other->info()) {
                const int j = other->index(face);
                add_edge(half, other->info(), cosine(other, j) > 0);
            }
        }
    }

    /// The gap is least in the middle of the two disks, where that lies on the way, or else at an end.
    void add_edge(const OpenEdge& half, std::size_t other, bool other_inside) {
        const double throat = half.midpoint_inside && other_inside
                                  ? half.midpoint_gap
                                  : std::min(graph_.vertices[half.vertex].radius, graph_.vertices[other].radius);
        graph_.edges.push_back({half.vertex, other, throat});
    }

    /// Edges across the ends of the period: the two halves are at different copies. One half alone goes to infinity.
    void match_open_edges() {
        std::ranges::sort(open_, {}, [](const OpenEdge& edge) { return std::tie(edge.key, edge.vertex); });
        for (std::size_t k = 1; k < open_.size(); ++k) {
            if (open_[k].key == open_[k - 1].key) add_edge(open_[k - 1], open_[k].vertex, open_[k].midpoint_inside);
        }
    }

    const TopView& view_;
    std::vector<Disk> disks_;
    Delaunay triangulation_;
    std::set<std::array<Corner, 3>> seen_;
    std::vector<OpenEdge> open_;
    VoronoiGraph graph_;
};

}  // namespace

VoronoiGraph voronoi_graph(const TopView& view) { return GraphBuilder(view).run(); }

}  // namespace recoat
