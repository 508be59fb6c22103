#include "analyzer/output/pore_cells.hpp"

#include <algorithm>

namespace recoat {

std::vector<GridPore> pore_cells(const Analysis& analysis, const AnalysisConfig& config,
                                 const DensityPoreMetrics& metrics) {
    std::vector<GridPore> pores = grid_pores(analysis.packing.exact, config.density_threshold, metrics.connectivity);
    std::ranges::stable_sort(pores, std::ranges::greater{}, [](const GridPore& pore) { return pore.cells.size(); });
    return pores;
}

Map pore_numbers(const Analysis& analysis, const AnalysisConfig& config, const DensityPoreMetrics& metrics) {
    const Map& phi = analysis.packing.exact;
    Map numbers(phi.first_x, phi.nx, phi.ny);
    double number = 0;
    for (const GridPore& pore : pore_cells(analysis, config, metrics)) {
        ++number;
        for (const GridCell cell : pore.cells) numbers.at(cell.ix, ((cell.iy % phi.ny) + phi.ny) % phi.ny) = number;
    }
    return numbers;
}

}  // namespace recoat
