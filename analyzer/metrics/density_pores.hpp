#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "analyzer/configuration.hpp"
#include "analyzer/fields/grid_pores.hpp"
#include "analyzer/fields/layer.hpp"
#include "analyzer/fields/map.hpp"
#include "analyzer/fields/pixel_shape.hpp"
#include "analyzer/metrics/pore_sizes.hpp"

namespace recoat {

/// One connected set of nodes of low packing density. Lengths in d_p.
struct DensityPore {
    std::size_t cells = 0;
    double area = 0;              ///< of the cells
    double diameter = 0;          ///< of the circle of the same area
    bool percolates = false;      ///< winds round the y period
    bool touches_x_edge = false;  ///< has a cell in the first or the last row of the map
    double x = 0, y = 0;  ///< mean of the unwrapped cells, from the start of the region and y_min; y in one period
    std::optional<PixelShape> shape;  ///< none for a pore that percolates
};

/// Size, number and direction of the density pores of a layer [paper section 5.4].
struct DensityPoreMetrics {
    GridConnectivity connectivity = GridConnectivity::sides;
    PoreSizes sizes;
    double area_fraction = 0;                      ///< cells in pores over all cells
    std::vector<std::size_t> angle_number_counts;  ///< pores per bin of the angle to x
    std::vector<std::size_t> angle_cell_counts;    ///< cells of these pores
    std::vector<DensityPore> pores;                ///< from large to small
};

/// Pores of a map of packing density: connected nodes below the threshold of the configuration.
[[nodiscard]] DensityPoreMetrics density_pore_metrics(const Map& phi, const Grid& grid, const AnalysisConfig& config,
                                                      GridConnectivity connectivity);

}  // namespace recoat
