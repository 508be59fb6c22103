#pragma once

#include <filesystem>

#include "analyzer/configuration.hpp"
#include "analyzer/fields/layer.hpp"

namespace recoat {

/// Writes a layer as OpenVDB: `solid`, a fog volume, 1 in every voxel of the region and one period whose centre is in a
/// sphere, with the voxels of the voxel forms; `distance`, a level set with cubes of side d_p / voxels_per_dp, the
/// signed distance to the surface of the spheres that reach into them, whole and unclipped. World coordinates are those
/// of the file of particles [um]; the grids carry d_p, voxels_per_dp and unit as metadata. Memory grows with the solid
/// and its surface, not with the region.
/// @throws InputError when the file cannot be written.
void write_voxel_volume(const std::filesystem::path& place, const Layer& layer, const AnalysisConfig& config,
                        int voxels_per_dp);

}  // namespace recoat
