#include "analyzer/output/json_report.hpp"

#include "analyzer/output/json_pores.hpp"
#include "analyzer/output/json_uncertainty.hpp"
#include "analyzer/output/pore_cells.hpp"

namespace recoat {
namespace {

using Json = nlohmann::ordered_json;

template <class Value>
Json or_null(const std::optional<Value>& value) {
    return value ? Json(*value) : Json(nullptr);
}

Json to_json(const BoxStats& stats) {
    return {{"n", stats.n},
            {"mean", stats.mean},
            {"median", stats.median},
            {"q1", stats.q1},
            {"q3", stats.q3},
            {"iqr", stats.iqr},
            {"iqr_over_median", or_null(stats.iqr_over_median)},
            {"whisker_lo", stats.whisker_lo},
            {"whisker_hi", stats.whisker_hi},
            {"n_outliers", stats.n_outliers},
            {"min", stats.min},
            {"max", stats.max}};
}

Json to_json(const HeightMetrics& height) {
    return {{"empty_fraction", height.empty_fraction},
            {"bin_upper_edges", height.bin_upper_edges},
            {"fraction", height.fraction},
            {"mean", height.mean},
            {"max", height.max},
            {"Ra", height.roughness},
            {"Ra_nonempty", height.roughness_nonempty}};
}

Json to_json(const OrientationMetrics& orientation) {
    Json groups = Json::object();
    for (const OrientationGroup& group : orientation.groups) {
        groups[std::string(group.name)] = {{"particles", group.particles},
                                           {"particles_without_angle", group.particles_without_angle},
                                           {"counts", group.counts},
                                           {"fraction_of_all", group.fraction_of_all}};
    }
    return groups;
}

Json clusters_to_json(const Analysis& analysis) {
    const CoordinationMetrics& coordination = analysis.coordination;
    const ClusterSizeMetrics& sizes = analysis.cluster_sizes;
    Json fractions = Json::object();
    for (const auto& [size, fraction] : sizes.size_fraction) fractions[std::to_string(size)] = fraction;
    return {{"n_particles", coordination.n_particles},
            {"n_contacts", coordination.n_contacts},
            {"cn_mean", coordination.cn_mean},
            {"cn_counts", coordination.cn_counts},
            {"cn_fraction", coordination.cn_fraction},
            {"n_clusters", sizes.n_clusters},
            {"n_percolating", sizes.n_percolating},
            {"n_isotropic", sizes.n_isotropic},
            {"max_cluster_size", sizes.max_cluster_size},
            {"size_fraction", fractions},
            {"orientation_bin_edges", analysis.orientation.bin_edges},
            {"orientation", to_json(analysis.orientation)}};
}

Json to_json(const VerticalMetrics& vertical) {
    Json json = {{"bin_centres", vertical.bin_centres}, {"fraction", vertical.fraction}};
    if (vertical.summary) {
        json["mean"] = vertical.summary->mean;
        json["max"] = vertical.summary->max;
        json["fraction_above_1dp"] = vertical.summary->fraction_above_1dp;
        json["fraction_touching_base"] = vertical.summary->fraction_touching_base;
    }
    return json;
}

Json to_json(const TotalsMetrics& totals) {
    Json json = {{"volume_whole_m3", totals.volume_whole},
                 {"volume_clipped_m3", totals.volume_clipped},
                 {"area_m2", totals.area},
                 {"mass_per_area", totals.mass_per_area},
                 {"mass_per_area_clipped", totals.mass_per_area_clipped},
                 {"layer_phi", totals.layer_phi}};
    if (totals.bed) {
        json["eq14_clipped"] = totals.bed->clipped;
        json["eq14_centre"] = totals.bed->centre;
        json["eq14_all"] = totals.bed->all;
    }
    return json;
}

Json to_json(const PoreErrors& errors) {
    Json json = {{"matched", errors.matched}, {"missed", errors.missed}, {"spurious", errors.spurious}};
    json["diameter_bias"] = errors.size ? Json(errors.size->bias) : Json(nullptr);
    json["diameter_deviation"] = errors.size ? Json(errors.size->deviation) : Json(nullptr);
    return json;
}

/// The true sides of cells and windows, along x and y.
Json to_json(const Grid& grid, const AnalysisConfig& config) {
    const auto sides = [&](double nominal) {
        const Sides side = grid.stretched(nominal);
        return Json({side.x, side.y});
    };
    return {{"cells", {grid.nx, grid.ny}},
            {"cell", sides(grid.spacing)},
            {"phi_window", sides(config.phi_window)},
            {"height_window", sides(config.height_window)}};
}

Json voxels_to_json(const Analysis& analysis) {
    Json json = Json::object();
    for (const VoxelMetrics& metrics : analysis.voxel) {
        const std::string key = std::to_string(metrics.voxels_per_dp);
        const VoxelLattice lattice = analysis.layer.voxels(metrics.voxels_per_dp);
        json[key] = {{"sides", {1 / lattice.per_x, 1 / lattice.per_y, 1 / lattice.per_z}},
                     {"phi", to_json(metrics.phi)},
                     {"phi_max_error", metrics.phi_error.max},
                     {"phi_rms_error", metrics.phi_error.rms},
                     {"density_pore_cells_8", metrics.density_pore_cells},
                     {"height", to_json(metrics.height)},
                     {"height_max_error", metrics.height_error.max},
                     {"chamber_P", json_pore_sizes(metrics.chambers.sizes)},
                     {"density_pore_errors_8", to_json(metrics.density_pore_errors)}};
        if (metrics.chamber_errors) json[key]["chamber_P_errors"] = to_json(*metrics.chamber_errors);
    }
    return json;
}

Json to_json(const Map& map) {
    Json rows = Json::array();
    for (int ix = 0; ix < map.nx; ++ix) {
        const auto begin = map.values.begin() + static_cast<std::ptrdiff_t>(ix) * map.ny;
        rows.push_back(std::vector<double>(begin, begin + map.ny));
    }
    return rows;
}

Json whole_numbers(const Map& map) {
    Json rows = Json::array();
    for (int ix = 0; ix < map.nx; ++ix) {
        Json row = Json::array();
        for (int iy = 0; iy < map.ny; ++iy) row.push_back(static_cast<int>(map.at(ix, iy)));
        rows.push_back(row);
    }
    return rows;
}

Json maps_to_json(const Analysis& analysis, const AnalysisConfig& config) {
    Json maps = {{"phi_exact", to_json(analysis.packing.exact)},
                 {"phi_centre", to_json(analysis.packing.centre)},
                 {"height", to_json(analysis.height_map)}};
    for (const DensityPoreMetrics& pores : analysis.density_pores) {
        maps["density_pore_" + std::to_string(static_cast<int>(pores.connectivity))] =
            whole_numbers(pore_numbers(analysis, config, pores));
    }
    return maps;
}

Json particles_to_json(const Analysis& analysis) {
    Json number = Json::array(), size = Json::array(), angle = Json::array();
    for (std::size_t i = 0; i < analysis.layer.size(); ++i) {
        const Cluster& cluster = analysis.clusters.cluster[analysis.clusters.of_particle[i]];
        number.push_back(analysis.coordination_numbers[i]);
        size.push_back(cluster.size);
        angle.push_back(or_null(cluster.angle));
    }
    return {{"cn", number}, {"cluster_size", size}, {"cluster_angle", angle}};
}

}  // namespace

Json json_config(const AnalysisConfig& config) {
    return {{"d_p", config.particle_diameter},
            {"density", config.density},
            {"h_b", config.clearance},
            {"base", config.base},
            {"x_range", {config.x_begin, config.x_end}},
            {"y_min", config.y_min},
            {"y_period", config.y_period},
            {"crop_first", config.crop_first},
            {"contact_factor", config.contact_factor},
            {"contact_mode", config.contact_mode == ContactMode::radii ? "radii" : "dp"},
            {"grid", config.grid},
            {"phi_window", config.phi_window},
            {"height_window", config.height_window},
            {"density_threshold", config.density_threshold},
            {"phi_x_edge", config.phi_x_edge == WindowEdge::interior ? "interior" : "overhang"},
            {"chamber_x_edge", config.chamber_x_edge == ChamberEdge::inside ? "inside" : "centre"},
            {"chamber_min_diameter", config.chamber_min_diameter},
            {"chamber_f", config.chamber_f},
            {"chamber_persistence", config.chamber_persistence},
            {"z_bin", config.z_bin},
            {"height_bin", config.height_bin},
            {"angle_bin", config.angle_bin},
            {"bin_tol", config.bin_tol},
            {"bootstrap_block", config.bootstrap_block},
            {"bootstrap_resamples", config.bootstrap_resamples},
            {"bootstrap_seed", config.bootstrap_seed},
            {"voxels_per_dp", config.voxels_per_dp}};
}

Json json_report(const Analysis& analysis, const AnalysisConfig& config,
                 const std::optional<Uncertainty>& uncertainty) {
    Json report = {{"units", "lengths in d_p"},
                   {"config", json_config(config)},
                   {"grid", to_json(analysis.layer.grid, config)},
                   {"clusters", clusters_to_json(analysis)},
                   {"vertical", to_json(analysis.vertical)},
                   {"phi_exact", to_json(analysis.phi_exact)},
                   {"phi_centre", to_json(analysis.phi_centre)},
                   {"height", to_json(analysis.height)},
                   {"totals", to_json(analysis.totals)},
                   {"chamber_pores", json_chamber_pores(analysis.chamber_pores)},
                   {"density_pores", json_density_pores(analysis.density_pores)},
                   {"voxel", voxels_to_json(analysis)},
                   {"maps", maps_to_json(analysis, config)},
                   {"particles", particles_to_json(analysis)}};
    if (uncertainty) report["uncertainty"] = json_uncertainty(*uncertainty);
    return report;
}

}  // namespace recoat
