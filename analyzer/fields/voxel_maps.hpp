#pragma once

#include "analyzer/configuration.hpp"
#include "analyzer/fields/layer.hpp"
#include "analyzer/fields/map.hpp"

namespace recoat {

/// The voxel forms of packing density and surface height, at the same nodes as the exact ones.
struct VoxelMaps {
    Map phi;     ///< solid share of the voxels whose centre is in the window box [-]
    Map height;  ///< top face of the highest solid voxel with its centre over the square [d_p]
};

/// Voxels as Layer::voxels() lays them. Where they do not fit the windows, windows of one size hold different numbers
/// of voxels; each density divides by that of its own.
[[nodiscard]] VoxelMaps voxel_maps(const Layer& layer, const AnalysisConfig& config, int voxels_per_dp);

}  // namespace recoat
