#pragma once

#include "analyzer/readers/reader.hpp"

namespace recoat {

/// Whether the file is of the legacy VTK format.
bool is_legacy_vtk(const Content& content);

/// Reads the points of POLYDATA and UNSTRUCTURED_GRID, ASCII and binary, versions 1 to 5.1, with size and identity from
/// the point data (SCALARS or FIELD). Cells are passed over; other kinds of data set are refused.
Series open_legacy_vtk(const Content& content, const ReadOptions& options);

inline constexpr Reader legacy_vtk_reader = {"legacy-vtk", "points in legacy VTK files (.vtk, ASCII or binary)",
                                             is_legacy_vtk, open_legacy_vtk};

}  // namespace recoat
