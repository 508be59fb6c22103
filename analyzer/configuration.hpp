#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analyzer/readers/source.hpp"
#include "common/config.hpp"

namespace recoat {

/// Which pairs count as contacts: centres closer than contact_factor x d_p, or than contact_factor x (r_i + r_j).
enum class ContactMode { particle_diameter, radii };

/// Nodes of the packing map whose window reaches out of the region: kept, or dropped.
enum class WindowEdge { overhang, interior };

/// Where a chamber pore must lie to be counted: its centre, or all of it, in the region.
enum class ChamberEdge { centre, inside };

/// The resolved configuration of an analysis. Lengths and the density are in SI units; what divides the layer into
/// windows and bins is in particle diameters.
struct AnalysisConfig {
    double particle_diameter = 0;    ///< d_p [m]
    double density = 0;              ///< of the solid [kg/m3]
    double clearance = 0;            ///< h_b, height of the blade above the base [m]
    double base = 0;                 ///< z of the base [m]
    double x_begin = 0, x_end = 0;   ///< region [m]
    double y_min = 0, y_period = 0;  ///< periodic direction [m]
    bool crop_first = false;         ///< drop particles outside the region before anything else
    double contact_factor = 1.005;   ///< [-]
    ContactMode contact_mode = ContactMode::radii;
    double grid = 1;                 ///< nominal side of a cell [d_p]
    double phi_window = 3;           ///< nominal side of the window of the packing density [d_p]
    double height_window = 1;        ///< nominal side of the window of the surface height [d_p]
    double density_threshold = 0.1;  ///< packing density below which a node belongs to a pore [-]
    WindowEdge phi_x_edge = WindowEdge::overhang;
    ChamberEdge chamber_x_edge = ChamberEdge::centre;
    double chamber_min_diameter = 0;         ///< [d_p]
    double chamber_f = 1;                    ///< [-]
    double chamber_persistence = 0.05;       ///< [d_p]
    double z_bin = 0.1;                      ///< [d_p]
    double height_bin = 0.25;                ///< [d_p]
    double angle_bin = 10;                   ///< [deg]
    double bin_tol = 1e-6;                   ///< tolerance of the edges of bins and windows [-]
    double bootstrap_block = 10;             ///< length of a block along x [d_p]
    std::size_t bootstrap_resamples = 1000;  ///< 0: no intervals
    std::uint64_t bootstrap_seed = 1;
    std::vector<int> voxels_per_dp = {10, 20};
};

/// Reads the analysis configuration. What the file of particles says of itself, or shows, stands in for d_p, density,
/// h_b, base, y_min, y_period and x_range where the configuration leaves them out.
/// @throws InputError naming the key when something is missing, unknown, out of range or does not fit together.
[[nodiscard]] AnalysisConfig read_analysis_config(const Config& config, const SourceInfo& info);

/// Names of the columns of a CSV file, from the section `columns`; empty where the usual names apply.
[[nodiscard]] ColumnNames read_column_names(const Config& config);

}  // namespace recoat
