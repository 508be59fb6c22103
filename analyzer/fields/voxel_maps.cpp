#include "analyzer/fields/voxel_maps.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <functional>

#include "analyzer/fields/packing_map.hpp"
#include "analyzer/fields/strip_sums.hpp"
#include "analyzer/fields/voxel_mask.hpp"

namespace recoat {
namespace {

using Leaf = openvdb::MaskTree::LeafNodeType;

/// Strip of a lattice that holds the centre of every voxel along x and y; -1 where windows do not reach.
struct VoxelStrips {
    std::vector<int> x, y;
    int i_begin;

    VoxelStrips(const StripLattice& lattice, int n, int first, int last, int period, double tolerance)
        : x(last - first), y(period), i_begin(first) {
        for (int i = first; i < last; ++i) {
            const int strip = lattice.strips.strip_of((i + 0.5) / n, tolerance);
            x[i - first] = strip >= 0 && strip < lattice.nx ? strip : -1;
        }
        for (int j = 0; j < period; ++j) {
            y[j] = lattice.wrap_y(lattice.strips.strip_of((j + 0.5) / n, tolerance));
        }
    }
};

/// A table that threads add whole numbers to, or raise: the result does not depend on the order.
class SharedTable {
public:
    explicit SharedTable(const StripLattice& lattice)
        : ny_(lattice.ny), values_(static_cast<std::size_t>(lattice.nx) * lattice.ny, 0) {}

    void add(int i, int j, std::int64_t amount) { entry(i, j).fetch_add(amount, std::memory_order_relaxed); }
    void raise(int i, int j, std::int64_t value) {
        const auto cell = entry(i, j);
        std::int64_t old = cell.load(std::memory_order_relaxed);
        while (old < value && !cell.compare_exchange_weak(old, value, std::memory_order_relaxed)) {
        }
    }
    [[nodiscard]] Map to_map() const {
        Map map(0, static_cast<int>(values_.size()) / ny_, ny_);
        std::ranges::copy(values_, map.values.begin());
        return map;
    }

private:
    std::atomic_ref<std::int64_t> entry(int i, int j) {
        return std::atomic_ref(values_[static_cast<std::size_t>(i) * ny_ + j]);
    }

    int ny_;
    std::vector<std::int64_t> values_;
};

/// Solid voxels below layer `top` of every column of a leaf, added up by strips.
void count_leaf(const Leaf& leaf, const VoxelStrips& strips, int top, SharedTable& counts) {
    const openvdb::Coord origin = leaf.origin();
    const int layers = std::clamp(top - origin.z(), 0, 8);
    if (layers == 0) return;
    const unsigned below = 0xFFu >> (8 - layers);
    for (int a = 0; a < 8; ++a) {
        const int i = origin.x() + a - strips.i_begin;
        if (i < 0 || i >= static_cast<int>(strips.x.size()) || strips.x[i] < 0) continue;
        std::int64_t sum = 0;
        for (int b = 0; b < 8; ++b) {
            const int j = origin.y() + b;
            if (j >= static_cast<int>(strips.y.size())) break;
            sum += std::popcount(leaf.getValueMask().getWord<std::uint8_t>(a * 8 + b) & below);
            const bool strip_ends =
                b == 7 || j + 1 == static_cast<int>(strips.y.size()) || strips.y[j + 1] != strips.y[j];
            if (strip_ends && sum > 0) counts.add(strips.x[i], strips.y[j], std::exchange(sum, 0));
        }
    }
}

/// One more than the index of the highest solid voxel of every column of a leaf.
void raise_leaf(const Leaf& leaf, const VoxelStrips& strips, SharedTable& tops) {
    const openvdb::Coord origin = leaf.origin();
    for (int a = 0; a < 8; ++a) {
        const int i = origin.x() + a - strips.i_begin;
        if (i < 0 || i >= static_cast<int>(strips.x.size()) || strips.x[i] < 0) continue;
        for (int b = 0; b < 8; ++b) {
            const unsigned column = leaf.getValueMask().getWord<std::uint8_t>(a * 8 + b);
            if (column != 0) tops.raise(strips.x[i], strips.y[origin.y() + b], origin.z() + std::bit_width(column));
        }
    }
}

/// Voxel centres in [0, extent) on a line, an edge counting as above.
int voxels_in(double extent, int n, double tolerance) {
    return static_cast<int>(std::ceil((extent - tolerance) * n - 0.5));
}

}  // namespace

VoxelMaps voxel_maps(const Layer& layer, const AnalysisConfig& config, int voxels_per_dp) {
    const int n = voxels_per_dp;
    const StripLattice phi_lattice(layer.grid, config.phi_window), height_lattice(layer.grid, config.height_window);
    const double overhang =
        std::max({0.0, 0.5 * (config.phi_window - config.grid), 0.5 * (config.height_window - config.grid)});
    const int i_begin = static_cast<int>(std::floor(-overhang * n)),
              period = static_cast<int>(std::lround(layer.width * n));
    const int i_end = static_cast<int>(std::ceil((layer.length + overhang) * n));
    const VoxelStrips phi_strips(phi_lattice, n, i_begin, i_end, period, config.bin_tol);
    const VoxelStrips height_strips(height_lattice, n, i_begin, i_end, period, config.bin_tol);
    SharedTable counts(phi_lattice), tops(height_lattice);
    const int layers = voxels_in(layer.clearance, n, config.bin_tol);
    visit_voxel_slabs(layer, n, i_begin, i_end, [&](const openvdb::MaskTree& mask) {
        for (auto leaf = mask.cbeginLeaf(); leaf; ++leaf) {
            count_leaf(*leaf, phi_strips, layers, counts);
            raise_leaf(*leaf, height_strips, tops);
        }
    });

    const NodeRange nodes = packing_nodes(layer.grid, config.phi_window, config.phi_x_edge);
    VoxelMaps maps{
        rows_of(over_windows(counts.to_map(), phi_lattice, layer.grid, std::plus<>{}), nodes.first, nodes.count),
        over_windows(tops.to_map(), height_lattice, layer.grid, [](double a, double b) { return std::max(a, b); })};
    const double columns = config.phi_window * n;
    for (double& value : maps.phi.values) value /= columns * columns * layers;
    for (double& value : maps.height.values) value /= n;
    return maps;
}

}  // namespace recoat
