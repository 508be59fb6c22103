#include "analyzer/analysis.hpp"

#include <algorithm>

#include "analyzer/fields/height_map.hpp"

namespace recoat {
namespace {

VoxelMetrics voxel_metrics(const Analysis& exact, const AnalysisConfig& config, int voxels_per_dp) {
    VoxelMetrics metrics;
    metrics.voxels_per_dp = voxels_per_dp;
    metrics.maps = voxel_maps(exact.layer, config, voxels_per_dp);
    metrics.phi = box_stats(metrics.maps.phi.values);
    metrics.phi_error = map_error(metrics.maps.phi, exact.packing.exact);
    metrics.height = height_metrics(metrics.maps.height, config.height_bin, config.bin_tol);
    metrics.height_error = map_error(metrics.maps.height, exact.height_map);
    for (const GridPore& pore :
         grid_pores(metrics.maps.phi, config.density_threshold, GridConnectivity::sides_and_corners)) {
        metrics.density_pore_cells.push_back(pore.cells.size());
    }
    std::ranges::sort(metrics.density_pore_cells);
    metrics.chambers = pixel_chamber_sizes(exact.layer, config, voxels_per_dp);
    return metrics;
}

}  // namespace

Analysis analyse(Layer layer, const AnalysisConfig& config) {
    Analysis result;
    result.layer = std::move(layer);
    result.contacts = find_contacts(result.layer, config);
    result.clusters = find_clusters(result.layer, result.contacts);
    result.coordination = coordination_metrics(result.layer, result.contacts);
    result.cluster_sizes = cluster_size_metrics(result.layer, result.clusters);
    result.orientation = orientation_metrics(result.layer, result.clusters, config.angle_bin, config.bin_tol);
    result.vertical = vertical_metrics(result.layer, config.z_bin, config.bin_tol);
    result.packing = packing_maps(result.layer, config);
    result.phi_exact = box_stats(result.packing.exact.values);
    result.phi_centre = box_stats(result.packing.centre.values);
    result.height_map = height_map(result.layer, config);
    result.height = height_metrics(result.height_map, config.height_bin, config.bin_tol);
    result.totals = totals_metrics(result.layer, config);
    for (const auto connectivity : {GridConnectivity::sides, GridConnectivity::sides_and_corners}) {
        result.density_pores.push_back(
            density_pore_metrics(result.packing.exact, result.layer.grid, config, connectivity));
    }
    result.chamber_pores = chamber_pore_metrics(result.layer, config);
    for (const int n : config.voxels_per_dp) result.voxel.push_back(voxel_metrics(result, config, n));
    return result;
}

}  // namespace recoat
