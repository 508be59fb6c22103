#include "analyzer/configuration.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include <fmt/format.h>

#include "analyzer/division.hpp"
#include "analyzer/region.hpp"
#include "common/number.hpp"

namespace recoat {
namespace {

using Words = std::array<std::string_view, 2>;

/// Cells that a region may have along one direction, and in all.
constexpr double most_cells = 1e8;

/// A value of the configuration, or else what the file of particles says.
double own_or_stated(const Config& config, std::string_view key, Dimension dimension, double stated, Range range = {}) {
    if (config.has(key) || std::isnan(stated)) return config.quantity(key, dimension, range);
    return stated;
}

/// A length as a bare number of particle diameters, or with a unit.
double diameters_or(const Config& config, std::string_view key, double diameter, double fallback,
                    Range range = Range::positive()) {
    if (!config.has(key) || parse_number(config.text(key))) return config.number_or(key, fallback, range);
    const double value = config.quantity(key, Dimension::length) / diameter;
    if (!range.contains(value))
        config.fail(key, fmt::format("{:.6g} d_p is out of range; give a larger length", value));
    return value;
}

/// An angle as a bare number of degrees, or with a unit.
double degrees_or(const Config& config, std::string_view key, double fallback, Range range) {
    if (!config.has(key) || parse_number(config.text(key))) return config.number_or(key, fallback, range);
    const double value = config.quantity(key, Dimension::angle) * 180 / std::numbers::pi;
    if (!range.contains(value))
        config.fail(key, fmt::format("{:.6g} deg is out of range; give an angle up to 90 deg", value));
    return value;
}

/// What neither the configuration nor a file of another code says.
void refuse_gaps(const Config& config, const SourceInfo& info) {
    if (std::isnan(info.x_lower)) return;
    if (!config.has("h_b") && std::isnan(info.clearance)) {
        config.fail("h_b",
                    "the file of particles does not say the clearance under the blade; give it in the "
                    "configuration (--config), or here: --set h_b=75um");
    }
    if (!config.has("density") && std::isnan(info.density)) {
        config.fail("density",
                    "the file of particles does not say the density of the solid; give it in the "
                    "configuration (--config), or here: --set density=4430");
    }
    if (!config.has("y_period") && std::isnan(info.y_period)) {
        config.fail("y_period",
                    fmt::format("the file of particles does not say that it is periodic along y, where it spans {:.9g} "
                                "... {:.9g} m; give the period: --period y=LOWER,UPPER",
                                info.y_lower, info.y_upper));
    }
}

/// Windows must lie in the period and, if outer nodes are dropped, in the region.
void check_windows(const Config& config, const AnalysisConfig& result, double nx, double ny) {
    for (const auto& [key, window] :
         {std::pair("phi_window", result.phi_window), std::pair("height_window", result.height_window)}) {
        if (window <= ny * result.grid + fits_within) continue;
        config.fail(key, fmt::format("the window is wider than the y period: {:.6g} d_p in a period of {:.6g} d_p; "
                                     "take a smaller one, e.g. --set {}={:.6g}dp",
                                     window, result.y_period / result.particle_diameter, key, ny * result.grid));
    }
    // Outer nodes drop in pairs, one at either end.
    const double dropped = std::max(0.0, std::ceil((result.phi_window / result.grid - 1) / 2 - fits_within));
    if (result.phi_x_edge == WindowEdge::interior && nx - 2 * dropped < 1) {
        config.fail("phi_x_edge", "no window lies in the region; take a smaller phi_window or a longer region");
    }
}

/// A grid that is asked for by name must fit; otherwise its cells are stretched.
void check_cells(const Config& config, const AnalysisConfig& result) {
    const double cell = result.grid * result.particle_diameter;
    const double nx = (result.x_end - result.x_begin) / cell, ny = result.y_period / cell;
    const bool must_fit = config.has("grid");
    if (nx < 0.5) {
        config.fail("x_range",
                    fmt::format("the region is {:.6g} m long, less than half a cell of {:.6g} m; give a longer one",
                                nx * cell, cell));
    }
    if (ny < 0.5) {
        config.fail("y_period",
                    fmt::format("the period is {:.6g} m, less than half a cell of {:.6g} m; give the period "
                                "of the particles, or smaller cells (grid)",
                                ny * cell, cell));
    }
    if (must_fit && !is_whole(nx)) {
        config.fail(
            "x_range",
            fmt::format("the region is {:.6g} cells of {:.6g} m long; make it a whole number of cells", nx, cell));
    }
    if (must_fit && !is_whole(ny)) {
        config.fail("y_period",
                    fmt::format("the period is {:.6g} cells of {:.6g} m; make it a whole number by the choice of grid, "
                                "or leave grid out",
                                ny, cell));
    }
    if (nx * ny > most_cells)
        config.fail("grid", fmt::format("{:.3g} cells are too many; take larger cells or a smaller region", nx * ny));
    check_windows(config, result, divide(nx).count, divide(ny).count);
}

void read_voxels(const Config& config, AnalysisConfig& result) {
    if (!config.has("voxels_per_dp")) return;
    result.voxels_per_dp.clear();
    for (const double n : config.quantities("voxels_per_dp", Dimension::none, 0, {.lower = 1, .upper = 1000})) {
        if (!is_whole(n))
            config.fail("voxels_per_dp", fmt::format("{:.6g} is no whole number; give a list like [10, 20]", n));
        result.voxels_per_dp.push_back(static_cast<int>(std::lround(n)));
    }
}

/// Voxels are stretched as cells are; windows hold whole ones where both fit. Windows that hold less than a voxel, or
/// that were asked for together with voxels that do not fit them, are refused.
void check_voxels(const Config& config, const AnalysisConfig& result) {
    const double d = result.particle_diameter, length = (result.x_end - result.x_begin) / d;
    for (const int n : result.voxels_per_dp) {
        const double narrowest =
            std::min(divide(length / result.grid).stretch / divide(length * n).stretch,
                     divide(result.y_period / d / result.grid).stretch / divide(result.y_period / d * n).stretch);
        for (const auto& [name, window] :
             {std::pair("phi_window", result.phi_window), std::pair("height_window", result.height_window)}) {
            const double voxels = window * n;
            if (voxels * narrowest < 1 - fits_within)
                config.fail("voxels_per_dp",
                            fmt::format("{} is less than one voxel at {} per d_p; take more", name, n));
            if (is_whole(voxels) || !config.has("voxels_per_dp")) continue;
            config.fail("voxels_per_dp",
                        fmt::format("{} is {:.6g} voxels at {} per d_p; choose a number that divides it into whole "
                                    "voxels, or another {}",
                                    name, voxels, n, name));
        }
        if (result.clearance / d * n < 1)
            config.fail("voxels_per_dp", fmt::format("h_b is less than one voxel at {} per d_p; take more", n));
        const double voxels = (length + result.phi_window + result.height_window) * n;
        if (voxels > 1e9 || result.y_period / d * n > 1e9)
            config.fail("voxels_per_dp", fmt::format("the region has too many voxels at {} per d_p; take fewer", n));
    }
}

void read_chambers(const Config& config, AnalysisConfig& result) {
    const double d = result.particle_diameter;
    result.density_threshold = config.number_or("density_threshold", 0.1, {.lower = 0, .upper = 1});
    result.chamber_x_edge = config.choice_or("chamber_x_edge", Words{"centre", "inside"}, "centre") == "inside"
                                ? ChamberEdge::inside
                                : ChamberEdge::centre;
    result.chamber_min_diameter = diameters_or(config, "chamber_min_diameter", d, 0, Range::not_negative());
    result.chamber_f = config.number_or("chamber_f", 1, Range::not_negative());
    result.chamber_persistence = diameters_or(config, "chamber_persistence", d, 0.05, Range::not_negative());
}

void read_bootstrap(const Config& config, AnalysisConfig& result) {
    result.bootstrap_block = diameters_or(config, "bootstrap_block", result.particle_diameter, 10);
    result.bootstrap_resamples =
        static_cast<std::size_t>(config.integer_or("bootstrap_resamples", 1000, {.lower = 0, .upper = 1e6}));
    result.bootstrap_seed = static_cast<std::uint64_t>(config.integer_or("bootstrap_seed", 1, Range::not_negative()));
}

void read_metrics(const Config& config, AnalysisConfig& result) {
    const double d = result.particle_diameter;
    result.crop_first = config.boolean_or("crop_first", false);
    result.contact_factor = config.number_or("contact_factor", 1.005, {.lower = 0, .upper = 10, .lower_open = true});
    result.contact_mode = config.choice_or("contact_mode", Words{"dp", "radii"}, "radii") == "dp"
                              ? ContactMode::particle_diameter
                              : ContactMode::radii;
    result.grid = diameters_or(config, "grid", d, 1);
    result.phi_window = diameters_or(config, "phi_window", d, 3);
    result.height_window = diameters_or(config, "height_window", d, 1);
    result.phi_x_edge = config.choice_or("phi_x_edge", Words{"overhang", "interior"}, "overhang") == "interior"
                            ? WindowEdge::interior
                            : WindowEdge::overhang;
    const Range bin = {.lower = 1e-4, .upper = 1e4};
    result.z_bin = diameters_or(config, "z_bin", d, 0.1, bin);
    result.height_bin = diameters_or(config, "height_bin", d, 0.25, bin);
    result.angle_bin = degrees_or(config, "angle_bin", 10, {.lower = 0.01, .upper = 90});
    result.bin_tol = config.number_or("bin_tol", 1e-6, {.lower = 0, .upper = 0.01});
}

}  // namespace

AnalysisConfig read_analysis_config(const Config& given, const SourceInfo& info) {
    Config config = given;
    config.set_plain_is_si(true);
    AnalysisConfig result;
    const auto positive = Range::positive();
    result.particle_diameter = own_or_stated(config, "d_p", Dimension::length, info.particle_diameter, positive);
    config.set_particle_diameter(result.particle_diameter);
    refuse_gaps(config, info);
    result.density = own_or_stated(config, "density", Dimension::density, info.density, positive);
    result.clearance = own_or_stated(config, "h_b", Dimension::length, info.clearance, positive);
    result.base = config.quantity_or("base", Dimension::length, std::isnan(info.base) ? 0 : info.base);
    result.y_min = own_or_stated(config, "y_min", Dimension::length, info.y_min);
    result.y_period = own_or_stated(config, "y_period", Dimension::length, info.y_period, positive);
    read_metrics(config, result);
    read_chambers(config, result);
    read_bootstrap(config, result);
    read_voxels(config, result);
    const double d = result.particle_diameter;
    const double overhang = std::max(0.0, 0.5 * (result.phi_window - result.grid)) * d;
    const Region region = read_region(config, info, {d, result.grid * d, overhang});
    result.x_begin = region.begin;
    result.x_end = region.end;
    config.finish();
    check_cells(config, result);
    check_voxels(config, result);
    return result;
}

ColumnNames read_column_names(const Config& config) {
    const Config columns = config.section_or_empty("columns");
    ColumnNames names;
    for (const auto& [key, name] :
         {std::pair("x", &names.x), std::pair("y", &names.y), std::pair("z", &names.z),
          std::pair("radius", &names.radius), std::pair("diameter", &names.diameter), std::pair("type", &names.type)}) {
        if (columns.has(key)) *name = columns.text(key);
    }
    if (!names.radius.empty() && !names.diameter.empty()) {
        columns.fail("diameter", "a radius column is named too; name the one that holds the size");
    }
    return names;
}

}  // namespace recoat
