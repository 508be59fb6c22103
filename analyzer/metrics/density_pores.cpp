#include "analyzer/metrics/density_pores.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace recoat {
namespace {

DensityPore measure(const GridPore& found, const Map& phi, const Grid& grid) {
    DensityPore pore;
    pore.cells = found.cells.size();
    pore.percolates = found.percolates;
    pore.area = static_cast<double>(pore.cells) * grid.cell().area();
    pore.diameter = std::sqrt(4 * pore.area / std::numbers::pi);
    double x = 0, y = 0;
    for (const GridCell cell : found.cells) {
        x += grid.node_x(phi.first_x + cell.ix);
        y += grid.node_y(cell.iy);
        pore.touches_x_edge |= cell.ix == 0 || cell.ix == phi.nx - 1;
    }
    const double period = phi.ny * grid.cell().y;
    pore.x = x / static_cast<double>(pore.cells);
    pore.y = y / static_cast<double>(pore.cells);
    pore.y -= period * std::floor(pore.y / period);
    if (!pore.percolates) pore.shape = pixel_shape(found.cells, grid.cell());
    return pore;
}

}  // namespace

DensityPoreMetrics density_pore_metrics(const Map& phi, const Grid& grid, const AnalysisConfig& config,
                                        GridConnectivity connectivity) {
    DensityPoreMetrics metrics;
    metrics.connectivity = connectivity;
    constexpr double right_angle = 90;
    const auto bins = static_cast<std::size_t>(std::ceil(right_angle / config.angle_bin - config.bin_tol));
    metrics.angle_number_counts.assign(bins, 0);
    metrics.angle_cell_counts.assign(bins, 0);
    std::vector<double> diameters;
    std::size_t cells = 0;
    for (const GridPore& found : grid_pores(phi, config.density_threshold, connectivity)) {
        const DensityPore pore = measure(found, phi, grid);
        diameters.push_back(pore.diameter);
        cells += pore.cells;
        metrics.pores.push_back(pore);
        if (!pore.shape || !pore.shape->angle) continue;
        const double bin = *pore.shape->angle / config.angle_bin + config.bin_tol;
        const std::size_t k = std::min(static_cast<std::size_t>(bin), bins - 1);
        metrics.angle_number_counts[k] += 1;
        metrics.angle_cell_counts[k] += pore.cells;
    }
    std::ranges::stable_sort(metrics.pores, std::ranges::greater{}, &DensityPore::cells);
    metrics.sizes = pore_sizes(std::move(diameters), config.bin_tol);
    if (!phi.values.empty())
        metrics.area_fraction = static_cast<double>(cells) / static_cast<double>(phi.values.size());
    return metrics;
}

}  // namespace recoat
