#include "analyzer/fields/voxel_mask.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "analyzer/fields/parallel.hpp"
#include "analyzer/fields/row_lists.hpp"

namespace recoat {
namespace {

static_assert(std::endian::native == std::endian::little, "a column of a leaf is one byte of its mask");

using Leaf = openvdb::MaskTree::LeafNodeType;
constexpr int leaf_side = Leaf::DIM;
constexpr int leaf_columns = leaf_side * leaf_side;
constexpr int slab_side = 128;  ///< voxels: one lower internal node of the tree, so that merging moves whole nodes

using ColumnSpans = std::array<RowRange, leaf_columns>;  ///< solid voxels along z per column of a leaf, index [x][y]

int floor_to_leaf(int index) { return index & ~(leaf_side - 1); }

/// Voxel centres in [low, high] as a range of indices, clipped to [begin, end).
RowRange voxels_between(double low, double high, int n, int begin, int end) {
    return {std::max(static_cast<int>(std::ceil(low * n - 0.5)), begin),
            std::min(static_cast<int>(std::floor(high * n - 0.5)), end - 1)};
}

/// One sphere, at one of its images along y.
struct Ball {
    double x, y, z, radius;
};

/// Turns on the voxels of a sphere within a box of the grid, leaf by leaf.
class Rasteriser {
public:
    Rasteriser(openvdb::MaskTree& tree, int n) : accessor_(tree), n_(n) {}

    void add(const Ball& ball, RowRange i, RowRange j) {
        for (int i_leaf = floor_to_leaf(i.first); i_leaf <= i.last; i_leaf += leaf_side) {
            for (int j_leaf = floor_to_leaf(j.first); j_leaf <= j.last; j_leaf += leaf_side) {
                add_block(ball, i, j, i_leaf, j_leaf);
            }
        }
    }

private:
    /// Spans of solid voxels in the columns of one stack of leaves.
    void add_block(const Ball& ball, RowRange i, RowRange j, int i_leaf, int j_leaf) {
        ColumnSpans spans;
        int lowest = std::numeric_limits<int>::max(), highest = -1;
        for (int a = 0; a < leaf_side; ++a) {
            for (int b = 0; b < leaf_side; ++b) {
                RowRange& span = spans[static_cast<std::size_t>(a) * leaf_side + b];
                span = {};
                if (i_leaf + a < i.first || i_leaf + a > i.last || j_leaf + b < j.first || j_leaf + b > j.last)
                    continue;
                span = span_of(ball, i_leaf + a, j_leaf + b);
                if (span.last < span.first) continue;
                lowest = std::min(lowest, span.first);
                highest = std::max(highest, span.last);
            }
        }
        for (int k_leaf = floor_to_leaf(lowest); k_leaf <= highest; k_leaf += leaf_side) {
            fill(*accessor_.touchLeaf({i_leaf, j_leaf, k_leaf}), spans, k_leaf);
        }
    }

    [[nodiscard]] RowRange span_of(const Ball& ball, int i, int j) const {
        const double dx = (i + 0.5) / n_ - ball.x, dy = (j + 0.5) / n_ - ball.y;
        const double square = ball.radius * ball.radius - dx * dx - dy * dy;
        if (square < 0) return {};
        const double half = std::sqrt(square);
        return voxels_between(ball.z - half, ball.z + half, n_, 0, std::numeric_limits<int>::max());
    }

    static void fill(Leaf& leaf, const ColumnSpans& spans, int k_leaf) {
        for (int column = 0; column < leaf_columns; ++column) {
            const int first = std::max(spans[column].first - k_leaf, 0);
            const int last = std::min(spans[column].last - k_leaf, leaf_side - 1);
            if (last < first) continue;
            const unsigned bits = (0xFFu >> (leaf_side - 1 - last)) & (0xFFu << first);
            leaf.getValueMask().getWord<std::uint8_t>(column) |= static_cast<std::uint8_t>(bits);
        }
    }

    openvdb::tree::ValueAccessor<openvdb::MaskTree> accessor_;
    int n_;
};

/// Adds the images of sphere `p` that reach into the period, within the voxels `slab` along x.
void add_sphere(Rasteriser& rasteriser, const Layer& layer, std::size_t p, int n, RowRange slab) {
    const double r = layer.radius[p];
    const int period = static_cast<int>(std::lround(layer.width * n));
    const RowRange i = voxels_between(layer.x[p] - r, layer.x[p] + r, n, slab.first, slab.last + 1);
    const int turns = static_cast<int>(std::ceil(r / layer.width));
    for (int turn = -turns; turn <= turns; ++turn) {
        const double y = layer.y[p] + turn * layer.width;
        const RowRange j = voxels_between(y - r, y + r, n, 0, period);
        if (i.first <= i.last && j.first <= j.last) rasteriser.add({layer.x[p], y, layer.z[p], r}, i, j);
    }
}

/// The rows of voxels along x, cut into slabs, and the spheres that reach into each.
class Slabs {
public:
    Slabs(const Layer& layer, int n, int i_begin, int i_end)
        : layer_(layer),
          n_(n),
          i_begin_(i_begin),
          i_end_(i_end),
          first_(slab_of(i_begin)),
          count_(slab_of(i_end - 1) - first_ + 1),
          lists_(ranges(), count_) {}

    [[nodiscard]] int count() const { return count_; }

    /// Turns on the voxels of a slab.
    void draw(int slab, openvdb::MaskTree& tree) const {
        Rasteriser rasteriser(tree, n_);
        const int begin = (first_ + slab) * slab_side;
        const RowRange rows = {std::max(begin, i_begin_), std::min(begin + slab_side, i_end_) - 1};
        for (const std::size_t p : lists_.items(slab)) add_sphere(rasteriser, layer_, p, n_, rows);
    }

private:
    static int slab_of(int i) { return static_cast<int>(std::floor(static_cast<double>(i) / slab_side)); }

    [[nodiscard]] std::vector<RowRange> ranges() const {
        std::vector<RowRange> result(layer_.size());
        for (std::size_t p = 0; p < layer_.size(); ++p) {
            const double x = layer_.x[p], r = layer_.radius[p];
            const RowRange i = voxels_between(x - r, x + r, n_, i_begin_, i_end_);
            if (i.first <= i.last) result[p] = {slab_of(i.first) - first_, slab_of(i.last) - first_};
        }
        return result;
    }

    const Layer& layer_;
    int n_, i_begin_, i_end_, first_, count_;
    RowLists lists_;
};

}  // namespace

openvdb::MaskTree voxel_mask(const Layer& layer, int voxels_per_dp, int i_begin, int i_end) {
    const Slabs slabs(layer, voxels_per_dp, i_begin, i_end);
    std::vector<openvdb::MaskTree> trees(static_cast<std::size_t>(slabs.count()));
    for_each_in_parallel(slabs.count(), [&](int s) { slabs.draw(s, trees[static_cast<std::size_t>(s)]); });
    openvdb::MaskTree whole;
    for (openvdb::MaskTree& tree : trees) whole.merge(tree, openvdb::MERGE_ACTIVE_STATES);
    return whole;
}

void visit_voxel_slabs(const Layer& layer, int voxels_per_dp, int i_begin, int i_end,
                       const std::function<void(const openvdb::MaskTree&)>& visit) {
    const Slabs slabs(layer, voxels_per_dp, i_begin, i_end);
    for_each_in_parallel(slabs.count(), [&](int s) {
        openvdb::MaskTree tree;
        slabs.draw(s, tree);
        visit(tree);
    });
}

}  // namespace recoat
