#include "analyzer/fields/voxel_maps.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <functional>
#include <span>

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

    VoxelStrips(const StripLattice& lattice, const VoxelLattice& voxels, int first, int last, double tolerance)
        : x(last - first), y(voxels.columns), i_begin(first) {
        for (int i = first; i < last; ++i) {
            const int strip = lattice.x.strip_of((i + 0.5) / voxels.per_x, tolerance);
            x[i - first] = strip >= 0 && strip < lattice.nx ? strip : -1;
        }
        for (std::size_t j = 0; j < y.size(); ++j) {
            y[j] = lattice.wrap_y(lattice.y.strip_of((static_cast<double>(j) + 0.5) / voxels.per_y, tolerance));
        }
    }
};

/// Voxels of every strip cell seen from above.
Map voxel_counts(const StripLattice& lattice, const VoxelStrips& strips) {
    std::vector<int> along_x(lattice.nx, 0), along_y(lattice.ny, 0);
    for (const int strip : strips.x) {
        if (strip >= 0) ++along_x[strip];
    }
    for (const int strip : strips.y) ++along_y[strip];
    Map counts(0, lattice.nx, lattice.ny);
    for (int i = 0; i < lattice.nx; ++i) {
        for (int j = 0; j < lattice.ny; ++j) counts.at(i, j) = static_cast<double>(along_x[i]) * along_y[j];
    }
    return counts;
}

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

/// The columns of a leaf that lie in one strip along y, one byte for each in a word of its mask.
struct StripBytes {
    int strip = 0;
    std::uint64_t bytes = 0;
};

/// Adds up leaves by strips. A word of the mask of a leaf holds the voxels of one row along x.
class LeafReader {
public:
    explicit LeafReader(const VoxelStrips& strips) : strips_(strips) {}

    /// Adds the solid voxels below layer `top`.
    void count(const Leaf& leaf, int top, SharedTable& counts) {
        const int layers = std::clamp(top - leaf.origin().z(), 0, 8);
        if (layers == 0) return;
        const std::uint64_t below = every_byte * (0xFFU >> (8 - layers));
        find_strips(leaf);
        for_each_strip(leaf, [&](int x, std::span<const std::uint64_t> words, StripBytes y) {
            std::int64_t sum = 0;
            for (const std::uint64_t word : words) sum += std::popcount(word & y.bytes & below);
            if (sum > 0) counts.add(x, y.strip, sum);
        });
    }

    /// Raises to one more than the index of the highest solid voxel.
    void raise(const Leaf& leaf, SharedTable& tops) {
        find_strips(leaf);
        for_each_strip(leaf, [&](int x, std::span<const std::uint64_t> words, StripBytes y) {
            std::uint64_t any = 0;
            for (const std::uint64_t word : words) any |= word & y.bytes;
            if (any == 0) return;
            for (const int half : {32, 16, 8}) any |= any >> half;
            tops.raise(x, y.strip, leaf.origin().z() + std::bit_width(any & 0xFF));
        });
    }

private:
    static constexpr std::uint64_t every_byte = 0x0101010101010101;

    void find_strips(const Leaf& leaf) {
        along_y_.clear();
        const int begin = leaf.origin().y();
        for (int b = 0; b < 8 && begin + b < static_cast<int>(strips_.y.size()); ++b) {
            const int strip = strips_.y[begin + b];
            if (along_y_.empty() || along_y_.back().strip != strip) along_y_.push_back({strip, 0});
            along_y_.back().bytes |= std::uint64_t{0xFF} << (8 * b);
        }
    }
    /// visit(strip along x, words of its rows, strip along y)
    template <class Visit>
    void for_each_strip(const Leaf& leaf, Visit visit) const {
        std::array<std::uint64_t, 8> words;
        for (int a = 0; a < 8; ++a) words[a] = leaf.getValueMask().getWord<std::uint64_t>(a);
        const int begin = leaf.origin().x() - strips_.i_begin, size = static_cast<int>(strips_.x.size());
        for (int a = std::max(-begin, 0), end = a; a < std::min(8, size - begin); a = end) {
            const int strip = strips_.x[begin + a];
            for (end = a + 1; end < std::min(8, size - begin) && strips_.x[begin + end] == strip;) ++end;
            if (strip < 0) continue;
            for (const StripBytes& y : along_y_) visit(strip, std::span(words).subspan(a, end - a), y);
        }
    }

    const VoxelStrips& strips_;
    std::vector<StripBytes> along_y_;
};

/// Voxel centres in [0, extent) on a line, an edge counting as above.
int voxels_in(double extent, double per_dp, double tolerance) {
    return static_cast<int>(std::ceil((extent - tolerance) * per_dp - 0.5));
}

}  // namespace

VoxelMaps voxel_maps(const Layer& layer, const AnalysisConfig& config, int voxels_per_dp) {
    const VoxelLattice voxels = layer.voxels(voxels_per_dp);
    const StripLattice phi_lattice(layer.grid, config.phi_window), height_lattice(layer.grid, config.height_window);
    const double widest = layer.grid.stretched(std::max(config.phi_window, config.height_window)).x;
    const double overhang = std::max(0.0, 0.5 * (widest - layer.grid.cell().x));
    const int i_begin = static_cast<int>(std::floor(-overhang * voxels.per_x));
    const int i_end = static_cast<int>(std::ceil((layer.length + overhang) * voxels.per_x));
    const VoxelStrips phi_strips(phi_lattice, voxels, i_begin, i_end, config.bin_tol);
    const VoxelStrips height_strips(height_lattice, voxels, i_begin, i_end, config.bin_tol);
    SharedTable counts(phi_lattice), tops(height_lattice);
    const int layers = voxels_in(layer.clearance, voxels.per_z, config.bin_tol);
    visit_voxel_slabs(layer, voxels, i_begin, i_end, [&](const openvdb::MaskTree& mask) {
        LeafReader for_phi(phi_strips), for_height(height_strips);
        for (auto leaf = mask.cbeginLeaf(); leaf; ++leaf) {
            for_phi.count(*leaf, layers, counts);
            for_height.raise(*leaf, tops);
        }
    });

    const NodeRange nodes = packing_nodes(layer.grid, config.phi_window, config.phi_x_edge);
    const auto over_phi_windows = [&](const Map& cells) {
        return rows_of(over_windows(cells, phi_lattice, layer.grid, std::plus<>{}), nodes.first, nodes.count);
    };
    VoxelMaps maps{over_phi_windows(counts.to_map()), over_windows(tops.to_map(), height_lattice, layer.grid,
                                                                   [](double a, double b) { return std::max(a, b); })};
    const Map all = over_phi_windows(voxel_counts(phi_lattice, phi_strips));
    for (std::size_t k = 0; k < all.values.size(); ++k) maps.phi.values[k] /= all.values[k] * layers;
    for (double& value : maps.height.values) value /= voxels.per_z;
    return maps;
}

}  // namespace recoat
