#include "analyzer/output/summary.hpp"

#include <cmath>

#include <fmt/format.h>

namespace recoat {
namespace {

/// Lines "what   value   lower   upper   standard error", no wider than a terminal of 80 columns.
class Table {
public:
    explicit Table(const std::optional<Uncertainty>& uncertainty) : uncertainty_(uncertainty) {
        text_ = fmt::format("{:<37}{:>9}", "", "value");
        if (uncertainty) text_ += fmt::format("{:>11}{:>11}{:>11}", "from", "to", "+-");
        text_ += "\n";
    }

    void add(std::string_view what, std::optional<double> value, std::string_view group, std::string_view name,
             std::size_t item = 0) {
        text_ += fmt::format("{:<37}{:>9}", what, number(value));
        if (uncertainty_ && !group.empty()) {
            const Interval interval = uncertainty_->at(group, name).interval.at(item);
            text_ += std::isfinite(interval.lower)
                         ? fmt::format("{:>11}{:>11}{:>11}", number(interval.lower), number(interval.upper),
                                       number(interval.standard_error))
                         : fmt::format("{:>22}", "no interval");
        }
        text_ += "\n";
    }
    void plain(std::string_view what, std::optional<double> value) { add(what, value, "", ""); }
    [[nodiscard]] const std::string& text() const { return text_; }

private:
    static std::string number(std::optional<double> value) {
        return value && std::isfinite(*value) ? fmt::format("{:.4g}", *value) : "undefined";
    }

    const std::optional<Uncertainty>& uncertainty_;
    std::string text_;
};

void add_surface(Table& table, const Analysis& analysis) {
    const BoxStats& phi = analysis.phi_exact;
    table.add("packing density, median", phi.median, "phi_exact", "median");
    table.add("  interquartile range / median", phi.iqr_over_median, "phi_exact", "iqr_over_median");
    table.add("  of the layer (solid / area h_b)", analysis.totals.layer_phi, "totals", "layer_phi");
    table.add("mass per area [kg/m2]", analysis.totals.mass_per_area, "totals", "mass_per_area");
    table.add("surface height, mean [d_p]", analysis.height.mean, "height", "mean");
    table.add("  roughness Ra [d_p]", analysis.height.roughness, "height", "Ra");
    table.add("  Ra without empty nodes [d_p]", analysis.height.roughness_nonempty, "height", "Ra_nonempty");
    table.add("  share of empty nodes", analysis.height.empty_fraction, "height", "empty_fraction");
}

void add_particles(Table& table, const Analysis& analysis) {
    const CoordinationMetrics& contacts = analysis.coordination;
    table.add("coordination number, mean", contacts.cn_mean, "clusters", "cn_mean");
    table.add("  share of particles without contact", contacts.cn_fraction[0], "clusters", "cn_fraction");
    table.plain("clusters of 2 or more, in the file", static_cast<double>(analysis.cluster_sizes.n_clusters));
    table.plain("  largest, in and out of the region", static_cast<double>(analysis.cluster_sizes.max_cluster_size));
    if (!analysis.vertical.summary) return;
    const auto& vertical = *analysis.vertical.summary;
    table.add("share of particles on the base", vertical.fraction_touching_base, "vertical", "fraction_touching_base");
    table.add("  with the centre above 1 d_p", vertical.fraction_above_1dp, "vertical", "fraction_above_1dp");
}

void add_sizes(Table& table, const PoreSizes& sizes, const std::string& group) {
    table.add("  median diameter [d_p]", sizes.median, group, "median");
    table.add("  mean diameter [d_p]", sizes.mean, group, "mean");
    table.plain("  largest diameter [d_p]", sizes.max);
}

void add_pores(Table& table, const Analysis& analysis) {
    for (const DensityPoreMetrics& pores : analysis.density_pores) {
        const int neighbours = static_cast<int>(pores.connectivity);
        const std::string group = fmt::format("density_pores/{}", neighbours);
        table.add(fmt::format("density pores, {} neighbours", neighbours), static_cast<double>(pores.sizes.count),
                  group, "count");
        add_sizes(table, pores.sizes, group);
        table.add("  share of the area", pores.area_fraction, group, "area_fraction");
    }
    const PoreSizes& chambers = analysis.chamber_pores.separate.sizes;
    table.add("chamber pores, rule A", static_cast<double>(chambers.count), "chamber_pores/A", "count");
    add_sizes(table, chambers, "chamber_pores/A");
    for (std::size_t k = 0; k < PoreSizes::groups; ++k) {
        const std::string range =
            k + 1 < PoreSizes::groups ? fmt::format("{} to {} d_p", k, k + 1) : fmt::format("{} d_p and more", k);
        table.add("  share of " + range, chambers.group_number_fraction[k], "chamber_pores/A", "group_number_fraction",
                  k);
    }
}

/// True sides of a cell or a window.
std::string sides(const Grid& grid, double nominal) {
    const Sides side = grid.stretched(nominal);
    return fmt::format("{:.6g} x {:.6g} d_p", side.x, side.y);
}

std::string head(const Analysis& analysis, const AnalysisConfig& config) {
    const double d = config.particle_diameter;
    const Grid& grid = analysis.layer.grid;
    std::string text = fmt::format("region      x = {:.9g} ... {:.9g} m ({:.6g} d_p)\n", config.x_begin, config.x_end,
                                   (config.x_end - config.x_begin) / d);
    text += fmt::format("            y period {:.9g} m ({:.6g} d_p), y from {:.9g} m\n", config.y_period,
                        analysis.layer.width, config.y_min);
    text +=
        fmt::format("frame       d_p {:.6g} m, h_b {:.6g} m, base z = {:.6g} m\n", d, config.clearance, config.base);
    text += fmt::format("grid        {} x {} cells of {}\n", grid.nx, grid.ny, sides(grid, grid.spacing));
    text += fmt::format("            density over windows of {}\n", sides(grid, config.phi_window));
    text += fmt::format("            height over windows of {}\n", sides(grid, config.height_window));
    text += fmt::format(
        "contacts    nearer than {:.6g} {} (contact_mode: {})\n", config.contact_factor,
        config.contact_mode == ContactMode::radii ? "times the sum of the radii" : "d_p, whatever the radii",
        config.contact_mode == ContactMode::radii ? "radii" : "dp");
    text += fmt::format("particles   {} in the region, {} in the file\n", analysis.coordination.n_particles,
                        analysis.layer.size());
    return text;
}

std::string voxel_lines(const Analysis& analysis) {
    std::string text;
    for (const VoxelMetrics& voxel : analysis.voxel) {
        const VoxelLattice lattice = analysis.layer.voxels(voxel.voxels_per_dp);
        text += fmt::format("voxels {:4} per d_p, sides {:.4g} x {:.4g} x {:.4g} d_p: from the exact values\n",
                            voxel.voxels_per_dp, 1 / lattice.per_x, 1 / lattice.per_y, 1 / lattice.per_z);
        text += fmt::format("            packing density within {:.2g} (rms {:.2g}), height within {:.2g} d_p\n",
                            voxel.phi_error.max, voxel.phi_error.rms, voxel.height_error.max);
    }
    return text;
}

}  // namespace

std::string text_summary(const Analysis& analysis, const AnalysisConfig& config,
                         const std::optional<Uncertainty>& uncertainty) {
    Table table(uncertainty);
    add_surface(table, analysis);
    add_particles(table, analysis);
    add_pores(table, analysis);
    std::string text = head(analysis, config);
    if (uncertainty) {
        text += fmt::format(
            "intervals   95 % (from, to) and standard error (+-), block bootstrap along x:\n"
            "            blocks of {:.6g} d_p, {} resamples, seed {}\n",
            uncertainty->block_length, uncertainty->bootstrap.resamples, uncertainty->bootstrap.seed);
    }
    return text + "\n" + table.text() + "\n" + voxel_lines(analysis);
}

}  // namespace recoat
