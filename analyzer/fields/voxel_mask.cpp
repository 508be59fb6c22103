#include "analyzer/fields/voxel_mask.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "analyzer/fields/parallel.hpp"
#include "analyzer/fields/row_lists.hpp"

namespace recoat {
namespace {

static_assert(std::endian::native == std::endian::little, "a column of a leaf is one byte of its mask");

using Leaf = openvdb::MaskTree::LeafNodeType;
constexpr int leaf_side = Leaf::DIM;
constexpr int leaf_columns = leaf_side * leaf_side;
constexpr int stack_height = 56;  ///< voxels of a column that are kept in one word: seven leaves
constexpr int slab_side = 128;    ///< voxels: one lower internal node of the tree, so that merging moves whole nodes

/// Solid voxels along z, first to end - 1, of every column of a leaf, index [x][y]; where there are none the first is
/// beyond all.
struct ColumnSpans {
    std::array<int, leaf_columns> first, end;
};

int floor_to_leaf(int index) { return index & ~(leaf_side - 1); }

/// Voxel centres in [low, high] as a range of indices, clipped to [begin, end).
RowRange voxels_between(double low, double high, double per_dp, int begin, int end) {
    return {std::max(static_cast<int>(std::ceil(low * per_dp - 0.5)), begin),
            std::min(static_cast<int>(std::floor(high * per_dp - 0.5)), end - 1)};
}

/// One sphere, at one of its images along y.
struct Ball {
    double x, y, z, radius;
};

/// Turns on the voxels of a sphere within a box of the grid, leaf by leaf.
class Rasteriser {
public:
    Rasteriser(openvdb::MaskTree& tree, const VoxelLattice& voxels) : accessor_(tree), voxels_(voxels) {}

    void add(const Ball& ball, RowRange i, RowRange j) {
        for (int i_leaf = floor_to_leaf(i.first); i_leaf <= i.last; i_leaf += leaf_side) {
            for (int j_leaf = floor_to_leaf(j.first); j_leaf <= j.last; j_leaf += leaf_side) {
                add_block(ball, i, j, i_leaf, j_leaf);
            }
        }
    }

private:
    /// The columns of one stack of leaves.
    void add_block(const Ball& ball, RowRange i, RowRange j, int i_leaf, int j_leaf) {
        ColumnSpans spans;
        int lowest = std::numeric_limits<int>::max(), highest = -1;
        const int a_first = std::max(i.first - i_leaf, 0), a_last = std::min(i.last - i_leaf, leaf_side - 1);
        for (int a = a_first; a <= a_last; ++a) {
            set_spans(ball, i_leaf + a, j, j_leaf, spans, a * leaf_side);
            for (int c = a * leaf_side; c < (a + 1) * leaf_side; ++c) {
                lowest = std::min(lowest, spans.first[c]);
                highest = std::max(highest, spans.end[c] - 1);
            }
        }
        for (int k = floor_to_leaf(lowest); k <= highest; k += stack_height) {
            const RowRange columns = {a_first * leaf_side, (a_last + 1) * leaf_side - 1};
            fill_stack(spans, columns, {i_leaf, j_leaf, k}, highest);
        }
    }

    /// The voxels of some columns in the leaves above one another from `origin` on.
    void fill_stack(const ColumnSpans& spans, RowRange columns, openvdb::Coord origin, int highest) {
        std::array<std::uint64_t, leaf_columns> bits;
        for (int c = columns.first; c <= columns.last; ++c) {
            bits[c] = bits_below(spans.end[c] - origin.z()) & ~bits_below(spans.first[c] - origin.z());
        }
        for (int up = 0; up < stack_height && origin.z() + up <= highest; up += leaf_side) {
            auto& mask = accessor_.touchLeaf(origin.offsetBy(0, 0, up))->getValueMask();
            for (int c = columns.first; c <= columns.last; c += leaf_side) {
                std::uint64_t word = 0;
                for (int b = 0; b < leaf_side; ++b) {
                    word |= (bits[c + b] >> up & 0xFF) << (b * leaf_side);
                }
                mask.getWord<std::uint64_t>(c / leaf_side) |= word;
            }
        }
    }
    /// The lowest bits, as many as there are up to `count`.
    static std::uint64_t bits_below(int count) { return (std::uint64_t{1} << std::clamp(count, 0, stack_height)) - 1; }

    /// Spans of a row of columns; without a branch, so that all are computed at once.
    void set_spans(const Ball& ball, int i, RowRange j, int j_leaf, ColumnSpans& spans, int column) const {
        constexpr double beyond = std::numeric_limits<int>::max();
        const double dx = (i + 0.5) / voxels_.per_x - ball.x, left = ball.radius * ball.radius - dx * dx;
        const double per_y = voxels_.per_y, n = voxels_.per_z;
        const double j_first = j.first, j_last = j.last;
        int* firsts = spans.first.data() + column;
        int* ends = spans.end.data() + column;
        for (int b = 0; b < leaf_side; ++b) {
            const double here = j_leaf + b, dy = (here + 0.5) / per_y - ball.y, square = left - dy * dy;
            const double half = std::sqrt(std::abs(square));
            const double first = std::ceil((ball.z - half) * n - 0.5), end = std::floor((ball.z + half) * n - 0.5) + 1;
            const double from = first > 0 ? first : 0;
            const bool solid = (square >= 0) & (end > from) & (here >= j_first) & (here <= j_last);
            firsts[b] = static_cast<int>(solid ? from : beyond);
            ends[b] = static_cast<int>(solid ? end : 0.0);
        }
    }

    openvdb::tree::ValueAccessor<openvdb::MaskTree> accessor_;
    VoxelLattice voxels_;
};

/// Adds the images of sphere `p` that reach into the period, within the voxels `slab` along x.
void add_sphere(Rasteriser& rasteriser, const Layer& layer, std::size_t p, const VoxelLattice& voxels, RowRange slab) {
    const double r = layer.radius[p];
    const int period = static_cast<int>(voxels.columns);
    const RowRange i = voxels_between(layer.x[p] - r, layer.x[p] + r, voxels.per_x, slab.first, slab.last + 1);
    const int turns = static_cast<int>(std::ceil(r / layer.width));
    for (int turn = -turns; turn <= turns; ++turn) {
        const double y = layer.y[p] + turn * layer.width;
        const RowRange j = voxels_between(y - r, y + r, voxels.per_y, 0, period);
        if (i.first <= i.last && j.first <= j.last) rasteriser.add({layer.x[p], y, layer.z[p], r}, i, j);
    }
}

/// The rows of voxels along x, cut into slabs, and the spheres that reach into each.
class Slabs {
public:
    Slabs(const Layer& layer, const VoxelLattice& voxels, int i_begin, int i_end)
        : layer_(layer),
          voxels_(voxels),
          i_begin_(i_begin),
          i_end_(i_end),
          first_(slab_of(i_begin)),
          count_(slab_of(i_end - 1) - first_ + 1),
          lists_(ranges(), count_) {}

    [[nodiscard]] int count() const { return count_; }

    /// Turns on the voxels of a slab.
    void draw(int slab, openvdb::MaskTree& tree) const {
        Rasteriser rasteriser(tree, voxels_);
        const int begin = (first_ + slab) * slab_side;
        const RowRange rows = {std::max(begin, i_begin_), std::min(begin + slab_side, i_end_) - 1};
        for (const std::size_t p : lists_.items(slab)) add_sphere(rasteriser, layer_, p, voxels_, rows);
    }

private:
    static int slab_of(int i) { return static_cast<int>(std::floor(static_cast<double>(i) / slab_side)); }

    [[nodiscard]] std::vector<RowRange> ranges() const {
        std::vector<RowRange> result(layer_.size());
        for (std::size_t p = 0; p < layer_.size(); ++p) {
            const double x = layer_.x[p], r = layer_.radius[p];
            const RowRange i = voxels_between(x - r, x + r, voxels_.per_x, i_begin_, i_end_);
            if (i.first <= i.last) result[p] = {slab_of(i.first) - first_, slab_of(i.last) - first_};
        }
        return result;
    }

    const Layer& layer_;
    VoxelLattice voxels_;
    int i_begin_, i_end_, first_, count_;
    RowLists lists_;
};

}  // namespace

openvdb::MaskTree voxel_mask(const Layer& layer, const VoxelLattice& voxels, int i_begin, int i_end) {
    const Slabs slabs(layer, voxels, i_begin, i_end);
    std::vector<openvdb::MaskTree> trees(static_cast<std::size_t>(slabs.count()));
    for_each_in_parallel(slabs.count(), [&](int s) { slabs.draw(s, trees[static_cast<std::size_t>(s)]); });
    openvdb::MaskTree whole;
    for (openvdb::MaskTree& tree : trees) whole.merge(tree, openvdb::MERGE_ACTIVE_STATES);
    return whole;
}

void visit_voxel_slabs(const Layer& layer, const VoxelLattice& voxels, int i_begin, int i_end,
                       const std::function<void(const openvdb::MaskTree&)>& visit) {
    const Slabs slabs(layer, voxels, i_begin, i_end);
    for_each_in_parallel(slabs.count(), [&](int s) {
        openvdb::MaskTree tree;
        slabs.draw(s, tree);
        visit(tree);
    });
}

}  // namespace recoat
