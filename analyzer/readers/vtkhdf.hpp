#pragma once

#include "analyzer/readers/reader.hpp"

namespace recoat {

/// Whether the file is HDF5 with the group of VTK.
bool is_vtkhdf(const Content& content);

/// Reads the points of PolyData and UnstructuredGrid in VTKHDF files of other codes, all parts together, with size,
/// identity and velocities from the point data. Steps count from 0. Other kinds of data set are refused.
Series open_vtkhdf(const Content& content, const ReadOptions& options);

inline constexpr Reader vtkhdf_reader = {"vtkhdf", "points in VTKHDF files of other codes (.vtkhdf)", is_vtkhdf,
                                         open_vtkhdf};

}  // namespace recoat
