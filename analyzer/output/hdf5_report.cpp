#include "analyzer/output/hdf5_report.hpp"

#include <array>
#include <limits>

#include "analyzer/output/described_group.hpp"
#include "analyzer/output/hdf5_pores.hpp"
#include "analyzer/output/hdf5_uncertainty.hpp"
#include "analyzer/output/json_report.hpp"
#include "analyzer/output/pore_cells.hpp"
#include "common/output_file.hpp"
#include "common/version.hpp"

namespace recoat {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::vector<double> scaled(std::vector<double> values, double factor, double offset = 0) {
    for (double& value : values) value = value * factor + offset;
    return values;
}

void write_config(const hdf5::Group& group, const AnalysisConfig& config) {
    const nlohmann::ordered_json json = json_config(config);
    for (const auto& [key, value] : json.items()) {
        if (value.is_string()) {
            group.set_attribute(key, value.get<std::string>());
        } else if (value.is_boolean()) {
            group.set_attribute(key, std::int64_t{value.get<bool>()});
        } else if (value.is_array()) {
            group.set_attribute(key, value.dump());
        } else {
            group.set_attribute(key, value.get<double>());
        }
    }
    group.set_attribute(
        "units",
        "d_p, h_b, base, x_range, y_min, y_period in m; density in kg/m3; angle_bin in deg; other lengths in d_p");
}

void write_grid(const DescribedGroup& group, const Grid& grid, const AnalysisConfig& config) {
    const auto sides = [&](const std::string& name, double nominal, const std::string& what) {
        const Sides side = grid.stretched(nominal);
        group.column(name, "d_p", "true sides along x and y of " + what, {side.x, side.y});
    };
    group.column("cells", "1", "number of cells along x and y", std::vector<int>{grid.nx, grid.ny});
    sides("cell", grid.spacing, "the cells, whose centres are the nodes");
    sides("phi_window", config.phi_window, "the windows of the packing density");
    sides("height_window", config.height_window, "the windows of the surface height");
}

void write_particles(const DescribedGroup& group, const Analysis& analysis, const AnalysisConfig& config) {
    const Layer& layer = analysis.layer;
    const double d = config.particle_diameter;
    std::vector<std::size_t> number(layer.size()), size(layer.size());
    std::vector<double> angle(layer.size());
    for (std::size_t i = 0; i < layer.size(); ++i) {
        const Cluster& cluster = analysis.clusters.cluster[analysis.clusters.of_particle[i]];
        number[i] = analysis.coordination_numbers[i];
        size[i] = cluster.size;
        angle[i] = cluster.angle.value_or(none);
    }
    group.column("file_index", "1", "place of the particle in the file, from 0", layer.file_index);
    group.column("x", "m", "centre along the spreading direction", scaled(layer.x, d, config.x_begin));
    group.column("y", "m", "centre across, wrapped into one period from y_min", scaled(layer.y, d, config.y_min));
    group.column("z", "m", "centre above the base", scaled(layer.z, d));
    group.column("radius", "m", "radius of the sphere", scaled(layer.radius, d));
    group.column("in_region", "1", "1 where the centre is in [x_begin, x_end)", layer.in_region);
    group.column("cn", "1", "coordination number: contacts with other particles", number);
    group.column("cluster", "1", "cluster of the particle, numbered by first particles in the file",
                 analysis.clusters.of_particle);
    group.column("cluster_size", "1", "particles in the cluster, inside and outside the region", size);
    group.column("cluster_angle", "deg", "angle of the cluster to the spreading direction, 0 to 90; NaN: none", angle);
}

/// Node positions of a map [m].
void write_axes(const DescribedGroup& group, const Map& map, const Grid& grid, const AnalysisConfig& config,
                const std::string& prefix) {
    const double d = config.particle_diameter;
    std::vector<double> x, y;
    for (int ix = 0; ix < map.nx; ++ix) x.push_back(config.x_begin + d * grid.node_x(map.first_x + ix));
    for (int iy = 0; iy < map.ny; ++iy) y.push_back(config.y_min + d * grid.node_y(iy));
    group.column(prefix + "_x", "m", "node positions along x of the " + prefix + " maps", x);
    group.column(prefix + "_y", "m", "node positions along y of the " + prefix + " maps", y);
}

void write_maps(const DescribedGroup& group, const Analysis& analysis, const AnalysisConfig& config) {
    write_axes(group, analysis.packing.exact, analysis.layer.grid, config, "phi");
    write_axes(group, analysis.height_map, analysis.layer.grid, config, "height");
    group.map("phi_exact", "1", "packing density: exact solid volume over the window of grid/phi_window, 0 to h_b",
              analysis.packing.exact);
    group.map("phi_centre", "1", "packing density: whole spheres with their centre in the window box",
              analysis.packing.centre);
    group.map("height", "d_p", "highest point of any sphere over the window of grid/height_window; 0: none",
              analysis.height_map);
    for (const DensityPoreMetrics& pores : analysis.density_pores) {
        const std::string neighbours = std::to_string(static_cast<int>(pores.connectivity));
        group.map("density_pore_" + neighbours, "1",
                  "density pore of the node, from 1 in the order of the table of pores; 0: none",
                  pore_numbers(analysis, config, pores));
    }
}

void write_box_stats(const DescribedGroup& group, const BoxStats& stats) {
    group.value("n", "1", "number of nodes", stats.n);
    group.value("mean", "1", "mean", stats.mean);
    group.value("median", "1", "median", stats.median);
    group.value("q1", "1", "first quartile, type 7", stats.q1);
    group.value("q3", "1", "third quartile, type 7", stats.q3);
    group.value("iqr", "1", "interquartile range", stats.iqr);
    group.value("iqr_over_median", "1", "interquartile range over median; NaN: median 0",
                stats.iqr_over_median.value_or(none));
    group.value("whisker_lo", "1", "smallest value not below q1 - 1.5 iqr", stats.whisker_lo);
    group.value("whisker_hi", "1", "largest value not above q3 + 1.5 iqr", stats.whisker_hi);
    group.value("n_outliers", "1", "values beyond the whiskers", stats.n_outliers);
    group.value("min", "1", "smallest value", stats.min);
    group.value("max", "1", "largest value", stats.max);
}

void write_height(const DescribedGroup& group, const HeightMetrics& height) {
    group.value("empty_fraction", "1", "nodes without any sphere, over all nodes", height.empty_fraction);
    group.column("bin_upper_edges", "d_p", "upper edges of the bins, which include them", height.bin_upper_edges);
    group.column("fraction", "1", "nodes with a sphere per bin, over all nodes", height.fraction);
    group.value("mean", "d_p", "mean height, empty nodes as 0", height.mean);
    group.value("max", "d_p", "largest height", height.max);
    group.value("Ra", "d_p", "mean |h - mean h|, empty nodes as 0", height.roughness);
    group.value("Ra_nonempty", "d_p", "mean |h - mean h| over the nodes with a sphere", height.roughness_nonempty);
}

void write_coordination(const DescribedGroup& group, const CoordinationMetrics& metrics) {
    group.value("n_particles", "1", "particles with their centre in the region", metrics.n_particles);
    group.value("n_contacts", "1", "pairs in contact in the whole file", metrics.n_contacts);
    group.value("cn_mean", "1", "mean coordination number of the region's particles", metrics.cn_mean);
    group.column("cn_counts", "1", "particles of the region with coordination number 0, 1, ...", metrics.cn_counts);
    group.column("cn_fraction", "1", "cn_counts over all particles of the region", metrics.cn_fraction);
}

void write_cluster_sizes(const DescribedGroup& group, const ClusterSizeMetrics& metrics) {
    group.value("n_clusters", "1", "clusters of two particles or more in the whole file", metrics.n_clusters);
    group.value("n_percolating", "1", "clusters that wind round the y period", metrics.n_percolating);
    group.value("n_isotropic", "1", "clusters without a direction in the top view", metrics.n_isotropic);
    group.value("max_cluster_size", "1", "largest cluster of the file", metrics.max_cluster_size);
    std::vector<std::size_t> size;
    std::vector<double> fraction;
    for (const auto& [key, value] : metrics.size_fraction) {
        size.push_back(key);
        fraction.push_back(value);
    }
    group.column("size", "1", "sizes of clusters that occur in the region", size);
    group.column("size_fraction", "1", "share of the region's particles in clusters of that size", fraction);
}

void write_orientation(const DescribedGroup& group, const OrientationMetrics& metrics) {
    group.column("bin_edges", "deg", "edges of the bins of the angle to the spreading direction", metrics.bin_edges);
    constexpr std::array<const char*, 3> names = {"size_2", "size_3_to_4", "size_5_and_more"};
    for (std::size_t g = 0; g < names.size(); ++g) {
        const DescribedGroup table = group.group(names[g]);
        const OrientationGroup& values = metrics.groups[g];
        table.value("particles", "1", "particles of the region in clusters of these sizes", values.particles);
        table.value("particles_without_angle", "1", "of these, in clusters without an angle",
                    values.particles_without_angle);
        table.column("counts", "1", "particles per bin", values.counts);
        table.column("fraction_of_all", "1", "counts over all particles of the region", values.fraction_of_all);
    }
}

void write_vertical(const DescribedGroup& group, const VerticalMetrics& metrics) {
    group.column("bin_centres", "d_p", "centres of the bins of the height of the centres", metrics.bin_centres);
    group.column("fraction", "1", "share of the region's particles per bin", metrics.fraction);
    if (!metrics.summary) return;
    group.value("mean", "d_p", "mean height of the centres", metrics.summary->mean);
    group.value("max", "d_p", "highest centre", metrics.summary->max);
    group.value("fraction_above_1dp", "1", "share with the centre above 1 d_p", metrics.summary->fraction_above_1dp);
    group.value("fraction_touching_base", "1", "share with z - r < 0.005 d_p", metrics.summary->fraction_touching_base);
}

void write_totals(const DescribedGroup& group, const TotalsMetrics& totals) {
    group.value("volume_whole", "m3", "whole spheres with their centre in the region", totals.volume_whole);
    group.value("volume_clipped", "m3", "exact solid between the x ends of the region", totals.volume_clipped);
    group.value("area", "m2", "area of the region", totals.area);
    group.value("mass_per_area", "kg/m2", "mass of the whole spheres over the area", totals.mass_per_area);
    group.value("mass_per_area_clipped", "kg/m2", "mass of the exact solid over the area",
                totals.mass_per_area_clipped);
    group.value("layer_phi", "1", "volume_clipped over area x h_b", totals.layer_phi);
    if (!totals.bed) return;
    group.value("eq14_clipped", "1", "exact solid in z_min to 0.9 z_max over that box", totals.bed->clipped);
    group.value("eq14_centre", "1", "whole spheres with their centre up to 0.9 z_max over that box",
                totals.bed->centre);
    group.value("eq14_all", "1", "all spheres of the region over that box", totals.bed->all);
}

void write_voxel(const DescribedGroup& group, const VoxelMetrics& metrics, const VoxelLattice& lattice) {
    group.column("sides", "d_p", "true sides of a voxel along x, y and z",
                 {1 / lattice.per_x, 1 / lattice.per_y, 1 / lattice.per_z});
    group.map("phi", "1", "packing density: solid share of the voxels of the window box", metrics.maps.phi);
    group.map("height", "d_p", "top face of the highest solid voxel over the window", metrics.maps.height);
    write_box_stats(group.group("phi_stats"), metrics.phi);
    write_height(group.group("height_stats"), metrics.height);
    group.value("phi_max_error", "1", "largest |voxel - exact| packing density of a node", metrics.phi_error.max);
    group.value("phi_rms_error", "1", "root mean square of voxel - exact packing density", metrics.phi_error.rms);
    group.value("height_max_error", "d_p", "largest |voxel - exact| height of a node", metrics.height_error.max);
    group.column("density_pore_cells_8", "1", "cells of the density pores by 8 neighbours, ascending",
                 metrics.density_pore_cells);
    write_pore_errors(group.group("density_pore_errors_8"), metrics.density_pore_errors);
    write_pore_sizes(group.group("chamber_P"), metrics.chambers.sizes);
    if (metrics.chamber_errors) write_pore_errors(group.group("chamber_P_errors"), *metrics.chamber_errors);
}

}  // namespace

void write_report_groups(const hdf5::Group& file, const Analysis& analysis, const AnalysisConfig& config,
                         const std::optional<Uncertainty>& uncertainty) {
    const auto group = [&](const std::string& name) { return DescribedGroup(file.create_group(name)); };
    write_config(file.create_group("config"), config);
    write_grid(group("grid"), analysis.layer.grid, config);
    write_particles(group("particles"), analysis, config);
    write_maps(group("maps"), analysis, config);
    write_coordination(group("coordination"), analysis.coordination);
    write_cluster_sizes(group("cluster_sizes"), analysis.cluster_sizes);
    write_orientation(group("orientation"), analysis.orientation);
    write_vertical(group("vertical"), analysis.vertical);
    write_box_stats(group("phi_exact"), analysis.phi_exact);
    write_box_stats(group("phi_centre"), analysis.phi_centre);
    write_height(group("height"), analysis.height);
    write_totals(group("totals"), analysis.totals);
    write_chamber_pores(group("chamber_pores"), analysis.chamber_pores, config);
    const DescribedGroup density_pores = group("density_pores");
    for (const DensityPoreMetrics& metrics : analysis.density_pores) {
        write_density_pores(density_pores.group(std::to_string(static_cast<int>(metrics.connectivity))), metrics,
                            config);
    }
    const DescribedGroup voxel = group("voxel");
    for (const VoxelMetrics& metrics : analysis.voxel) {
        write_voxel(voxel.group(std::to_string(metrics.voxels_per_dp)), metrics,
                    analysis.layer.voxels(metrics.voxels_per_dp));
    }
    if (uncertainty) write_uncertainty(file.create_group("uncertainty"), *uncertainty);
}

hdf5::File create_hdf5_report(const std::filesystem::path& path, const Provenance& provenance) {
    constexpr std::int64_t schema_version = 1;
    hdf5::File file = hdf5::File::create(path);
    file.set_attribute("content", "recoat layer analysis");
    file.set_attribute("schema_version", schema_version);
    file.set_attribute("program_version", program_version());
    file.set_attribute("source_file", provenance.file);
    file.set_attribute("source_format", provenance.format);
    return file;
}

void write_hdf5_report(const std::filesystem::path& path, const Analysis& analysis, const AnalysisConfig& config,
                       const Provenance& provenance, const std::optional<Uncertainty>& uncertainty) {
    OutputFile output(path);
    {
        const hdf5::File file = create_hdf5_report(output.path(), provenance);
        write_report_groups(file, analysis, config, uncertainty);
    }
    output.commit();
}

}  // namespace recoat
