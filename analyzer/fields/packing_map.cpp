#include "analyzer/fields/packing_map.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "analyzer/fields/parallel.hpp"
#include "analyzer/fields/row_lists.hpp"
#include "analyzer/fields/sphere_box.hpp"
#include "analyzer/fields/strip_sums.hpp"

namespace recoat {
namespace {

/// Strip cells that a sphere reaches, and where its volumes in them are stored.
struct Patch {
    RowRange x, y;  ///< y strips before wrapping
    std::size_t start = 0;

    [[nodiscard]] int columns() const { return y.last - y.first + 1; }
    [[nodiscard]] std::size_t size() const {
        return x.last < x.first ? 0 : static_cast<std::size_t>(x.last - x.first + 1) * columns();
    }
};

std::vector<Patch> find_patches(const Layer& layer, const StripLattice& lattice) {
    std::vector<Patch> patches(layer.size());
    std::size_t start = 0;
    for (std::size_t p = 0; p < layer.size(); ++p) {
        const double r = layer.radius[p], z = layer.z[p];
        Patch& patch = patches[p];
        patch.start = start;
        if (z + r <= 0 || z - r >= layer.clearance) continue;
        patch.x = {std::max(lattice.x.strip_of(layer.x[p] - r), 0),
                   std::min(lattice.x.strip_of(layer.x[p] + r), lattice.nx - 1)};
        patch.y = {lattice.y.strip_of(layer.y[p] - r), lattice.y.strip_of(layer.y[p] + r)};
        start += patch.size();
    }
    return patches;
}

/// Volumes of sphere p in the cells of its patch: second differences of corner volumes over the crossings of the edges.
void cut_sphere(const Layer& layer, const StripLattice& strips, std::size_t p, const Patch& patch, double* volume) {
    const double r = layer.radius[p], x = layer.x[p], y = layer.y[p];
    const double bottom = -layer.z[p] / r, top = (layer.clearance - layer.z[p]) / r;
    const int columns = patch.columns();
    const auto beyond = [&](int i, int j) {
        const double a = (strips.x.edge(i) - x) / r, b = (strips.y.edge(j) - y) / r;
        return ball_corner(a, b, bottom) - ball_corner(a, b, top);
    };
    std::vector<double> row(columns + 1), next(columns + 1);
    for (int j = 0; j <= columns; ++j) row[j] = beyond(patch.x.first, patch.y.first + j);
    for (int i = patch.x.first; i <= patch.x.last; ++i) {
        for (int j = 0; j <= columns; ++j) next[j] = beyond(i + 1, patch.y.first + j);
        const double gap_x = squared_distance_to_interval(x, strips.x.edge(i), strips.x.edge(i + 1));
        for (int j = 0; j < columns; ++j) {
            const int strip = patch.y.first + j;
            const double gap_y = squared_distance_to_interval(y, strips.y.edge(strip), strips.y.edge(strip + 1));
            // A cell beside the sphere is empty exactly, not up to round-off: medians and outliers hang on it.
            const double share = gap_x + gap_y < r * r ? (row[j] - next[j]) - (row[j + 1] - next[j + 1]) : 0;
            *volume++ = std::max(share, 0.0) * r * r * r;
        }
        row.swap(next);
    }
}

/// Solid volume between the base and h_b in every cell of the lattice.
Map cell_volumes(const Layer& layer, const StripLattice& lattice) {
    const std::vector<Patch> patches = find_patches(layer, lattice);
    std::vector<double> volumes(patches.empty() ? 0 : patches.back().start + patches.back().size());
    for_each_in_parallel(layer.size(), [&](std::size_t p) {
        if (patches[p].size() > 0) cut_sphere(layer, lattice, p, patches[p], &volumes[patches[p].start]);
    });
    std::vector<RowRange> ranges(patches.size());
    std::ranges::transform(patches, ranges.begin(), &Patch::x);
    const RowLists lists(ranges, lattice.nx);
    Map cells(0, lattice.nx, lattice.ny);
    for_each_in_parallel(lattice.nx, [&](int i) {
        for (const std::size_t p : lists.items(i)) {
            const Patch& patch = patches[p];
            const double* volume =
                &volumes[patch.start + static_cast<std::size_t>(i - patch.x.first) * patch.columns()];
            for (int j = patch.y.first; j <= patch.y.last; ++j) cells.at(i, lattice.wrap_y(j)) += *volume++;
        }
    });
    return cells;
}

/// Volume of the spheres with their centre in every cell of the lattice.
Map centre_volumes(const Layer& layer, const StripLattice& lattice, double tolerance) {
    Map cells(0, lattice.nx, lattice.ny);
    for (std::size_t p = 0; p < layer.size(); ++p) {
        if (layer.z[p] < -tolerance || layer.z[p] >= layer.clearance - tolerance) continue;
        const int i = lattice.x.strip_of(layer.x[p], tolerance);
        if (i < 0 || i >= lattice.nx) continue;
        cells.at(i, lattice.wrap_y(lattice.y.strip_of(layer.y[p], tolerance))) += sphere_volume(layer.radius[p]);
    }
    return cells;
}

}  // namespace

NodeRange packing_nodes(const Grid& grid, double window, WindowEdge edge) {
    if (edge == WindowEdge::overhang) return {0, grid.nx};
    const double overhang = 0.5 * (window - grid.spacing) / grid.spacing;
    const int dropped = std::max(0, static_cast<int>(std::ceil(overhang - 1e-9)));
    return {dropped, std::max(0, grid.nx - 2 * dropped)};
}

PackingMaps packing_maps(const Layer& layer, const AnalysisConfig& config) {
    const StripLattice lattice(layer.grid, config.phi_window);
    const NodeRange nodes = packing_nodes(layer.grid, config.phi_window, config.phi_x_edge);
    const double box = layer.grid.stretched(config.phi_window).area() * layer.clearance;
    const auto density = [&](const Map& cells) {
        Map map = rows_of(over_windows(cells, lattice, layer.grid, std::plus<>{}), nodes.first, nodes.count);
        for (double& value : map.values) value /= box;
        return map;
    };
    return {density(cell_volumes(layer, lattice)), density(centre_volumes(layer, lattice, config.bin_tol))};
}

}  // namespace recoat
