#pragma once

#include <filesystem>

#include "analyzer/configuration.hpp"
#include "analyzer/fields/layer.hpp"

namespace recoat {

/// Writes a layer as OpenVDB with voxels of side d_p / voxels_per_dp: `solid`, a fog volume, 1 in every voxel of the
/// region and one period whose centre is in a sphere; `distance`, a level set, the signed distance [m] to the surface
/// of the spheres that reach into them, whole and unclipped. World coordinates are those of the file of particles [m];
/// the grids carry d_p, voxels_per_dp and unit as metadata. Memory grows with the solid and its surface, not with the
/// region.
/// @throws InputError when the period is no whole number of voxels or the file cannot be written.
void write_voxel_volume(const std::filesystem::path& place, const Layer& layer, const AnalysisConfig& config,
                        int voxels_per_dp);

}  // namespace recoat
