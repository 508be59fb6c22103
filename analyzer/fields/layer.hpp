#pragma once

#include <cstddef>
#include <vector>

#include "analyzer/configuration.hpp"
#include "analyzer/fields/grid.hpp"
#include "analyzer/fields/voxel_lattice.hpp"
#include "analyzer/readers/source.hpp"

namespace recoat {

/// A layer in particle diameters: x from the start of the region, y wrapped into [0, width) from y_min, z from the
/// base. Particles keep the order of the file.
struct Layer {
    std::vector<double> x, y, z, radius;  ///< [N] d_p
    std::vector<char> in_region;          ///< [N] whether the centre is in [0, length)
    std::vector<std::size_t> file_index;  ///< [N] place of the particle in the file
    double length = 0, width = 0;         ///< of the region along x and of the period along y [d_p]
    double clearance = 0;                 ///< h_b [d_p]
    Grid grid;

    [[nodiscard]] std::size_t size() const { return x.size(); }
    [[nodiscard]] VoxelLattice voxels(int per_dp) const { return {length, width, per_dp}; }
};

/// Brings the particles of a file into the frame of the analysis.
/// @throws InputError when a particle is so far away or so large that the unit of length must be wrong.
[[nodiscard]] Layer make_layer(const Source& source, const AnalysisConfig& config);

}  // namespace recoat
