#pragma once

#include "analyzer/readers/reader.hpp"

namespace recoat {

/// Whether the file names the pieces of one data set (.pvtu, .pvtp), or its blocks (.vtm).
bool is_vtk_pieces(const Content& content);
/// Whether the file names the files of time steps as ParaView's XML does (.pvd).
bool is_vtk_collection(const Content& content);
/// Whether the file names the files of time steps as ParaView's JSON does (.vtk.series, .vtp.series, ...).
bool is_vtk_series(const Content& content);

/// The particles of all pieces together. The files are looked for beside this one. Steps, and what a piece may hold, as
/// for one file.
Series open_vtk_pieces(const Content& content, const ReadOptions& options);

/// A time step for every time; the particles of its parts together. Steps count from 0. The files may be of any format
/// that holds one time step.
Series open_vtk_collection(const Content& content, const ReadOptions& options);

/// As open_vtk_collection, from JSON.
Series open_vtk_series(const Content& content, const ReadOptions& options);

inline constexpr Reader vtk_pieces_reader = {"vtk-pieces", "heads of VTK files in pieces (.pvtu, .pvtp, .vtm)",
                                             is_vtk_pieces, open_vtk_pieces};
inline constexpr Reader vtk_collection_reader = {"vtk-collection", "time steps in files of their own (.pvd)",
                                                 is_vtk_collection, open_vtk_collection};
inline constexpr Reader vtk_series_reader = {"vtk-series", "time steps in files of their own, as JSON (.vtk.series)",
                                             is_vtk_series, open_vtk_series};

}  // namespace recoat
