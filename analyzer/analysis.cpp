#include "analyzer/analysis.hpp"

#include <algorithm>

#include "analyzer/fields/height_map.hpp"
#include "analyzer/fields/spatial_order.hpp"

namespace recoat {
namespace {

/// Chambers that are compared with those in pixels: smaller ones are the holes between touching spheres [d_p].
constexpr double least_diameter = 0.5;
/// Farthest that the same chamber may lie in the two forms [d_p].
constexpr double partner_reach = 0.3;

std::vector<Circle> wide_circles(const std::vector<Circle>& circles) {
    std::vector<Circle> result;
    std::ranges::copy_if(circles, std::back_inserter(result),
                         [](const Circle& circle) { return 2 * circle.radius >= least_diameter; });
    return result;
}

VoxelMetrics voxel_metrics(const Layer& layer, const Analysis& exact, const AnalysisConfig& config, int voxels_per_dp) {
    VoxelMetrics metrics;
    metrics.voxels_per_dp = voxels_per_dp;
    metrics.maps = voxel_maps(layer, config, voxels_per_dp);
    metrics.phi = box_stats(metrics.maps.phi.values);
    metrics.phi_error = map_error(metrics.maps.phi, exact.packing.exact);
    metrics.height = height_metrics(metrics.maps.height, config.height_bin, config.bin_tol);
    metrics.height_error = map_error(metrics.maps.height, exact.height_map);
    for (const GridPore& pore :
         grid_pores(metrics.maps.phi, config.density_threshold, GridConnectivity::sides_and_corners)) {
        metrics.density_pore_cells.push_back(pore.cells.size());
    }
    std::ranges::sort(metrics.density_pore_cells);
    metrics.density_pore_errors =
        density_pore_errors(exact.packing.exact, metrics.maps.phi, config.density_threshold, layer.grid.cell().area());
    metrics.chambers = pixel_chambers(layer, config, voxels_per_dp);
    if (exact.chamber_pores.persistent) {
        metrics.chamber_errors = chamber_errors(wide_circles(exact.chamber_pores.persistent->circles),
                                                wide_circles(metrics.chambers.circles), layer.width, partner_reach);
    }
    return metrics;
}

}  // namespace

Analysis analyse(Layer layer, const AnalysisConfig& config) {
    Analysis result;
    const SpatialOrder order(layer);
    const Layer sorted = order.apply(layer);
    result.layer = std::move(layer);
    const ContactGraph contacts = find_contacts(sorted, config);
    const Clusters clusters = find_clusters(sorted, contacts);
    result.coordination = coordination_metrics(sorted, contacts);
    result.cluster_sizes = cluster_size_metrics(sorted, clusters);
    result.orientation = orientation_metrics(sorted, clusters, config.angle_bin, config.bin_tol);
    result.coordination_numbers = order.coordination_numbers(contacts);
    result.clusters = order.restore(clusters);
    result.vertical = vertical_metrics(sorted, config.z_bin, config.bin_tol);
    result.packing = packing_maps(sorted, config);
    result.phi_exact = box_stats(result.packing.exact.values);
    result.phi_centre = box_stats(result.packing.centre.values);
    result.height_map = height_map(sorted, config);
    result.height = height_metrics(result.height_map, config.height_bin, config.bin_tol);
    result.totals = totals_metrics(sorted, config);
    for (const auto connectivity : {GridConnectivity::sides, GridConnectivity::sides_and_corners}) {
        result.density_pores.push_back(density_pore_metrics(result.packing.exact, sorted.grid, config, connectivity));
    }
    result.chamber_pores = chamber_pore_metrics(sorted, config);
    for (const int n : config.voxels_per_dp) result.voxel.push_back(voxel_metrics(sorted, result, config, n));
    return result;
}

}  // namespace recoat
