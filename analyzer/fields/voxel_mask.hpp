#pragma once

#include <functional>

#include <openvdb/openvdb.h>

#include "analyzer/fields/layer.hpp"

namespace recoat {

/// Solid voxels of a layer as a sparse tree of bits: on where the centre of the voxel is in a sphere.
///
/// j lies in one period; voxels below the base and outside i_begin <= i < i_end are left out. Memory grows with the
/// solid, not with the region. Built in parallel; the tree does not depend on the number of threads.
[[nodiscard]] openvdb::MaskTree voxel_mask(const Layer& layer, const VoxelLattice& voxels, int i_begin, int i_end);

/// The same voxels slab by slab along x, in a memory that does not grow with the layer: visit(tree) for each slab, from
/// several threads at once, in any order.
void visit_voxel_slabs(const Layer& layer, const VoxelLattice& voxels, int i_begin, int i_end,
                       const std::function<void(const openvdb::MaskTree&)>& visit);

}  // namespace recoat
