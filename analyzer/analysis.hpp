#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analyzer/configuration.hpp"
#include "analyzer/fields/clusters.hpp"
#include "analyzer/fields/contact_graph.hpp"
#include "analyzer/fields/layer.hpp"
#include "analyzer/fields/packing_map.hpp"
#include "analyzer/fields/voxel_maps.hpp"
#include "analyzer/metrics/box_stats.hpp"
#include "analyzer/metrics/chamber_pores.hpp"
#include "analyzer/metrics/cluster_sizes.hpp"
#include "analyzer/metrics/coordination.hpp"
#include "analyzer/metrics/density_pores.hpp"
#include "analyzer/metrics/height.hpp"
#include "analyzer/metrics/orientation.hpp"
#include "analyzer/metrics/packing.hpp"
#include "analyzer/metrics/pixel_chambers.hpp"
#include "analyzer/metrics/pore_errors.hpp"
#include "analyzer/metrics/totals.hpp"
#include "analyzer/metrics/vertical.hpp"

namespace recoat {

/// The voxel forms at one resolution, and how far they are from the exact ones.
struct VoxelMetrics {
    int voxels_per_dp = 0;
    VoxelMaps maps;
    BoxStats phi;
    MapError phi_error;
    HeightMetrics height;
    MapError height_error;
    std::vector<std::size_t> density_pore_cells;  ///< of the pores by 8 neighbours, ascending
    PoreErrors density_pore_errors;               ///< of these
    PixelChambers chambers;                       ///< pixel form of rule P
    std::optional<PoreErrors> chamber_errors;     ///< of those of half a diameter and more; for equal radii only
};

/// Everything that is measured of a layer. Lengths in d_p unless a name says otherwise.
struct Analysis {
    Layer layer;
    std::vector<std::uint32_t> coordination_numbers;  ///< of the particles
    Clusters clusters;
    CoordinationMetrics coordination;
    ClusterSizeMetrics cluster_sizes;
    OrientationMetrics orientation;
    VerticalMetrics vertical;
    PackingMaps packing;
    BoxStats phi_exact, phi_centre;
    Map height_map;
    HeightMetrics height;
    std::vector<DensityPoreMetrics> density_pores;  ///< by 4-neighbours and by 8-neighbours
    ChamberPoreMetrics chamber_pores;
    TotalsMetrics totals;
    std::vector<VoxelMetrics> voxel;
};

/// Measures a layer. A pure function: the same layer gives the same bits with any number of threads.
[[nodiscard]] Analysis analyse(Layer layer, const AnalysisConfig& config);

}  // namespace recoat
