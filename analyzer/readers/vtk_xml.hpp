#pragma once

#include "analyzer/readers/reader.hpp"

namespace recoat {

/// Whether the file is of the XML formats of VTK, whatever its ending.
bool is_vtk_xml(const Content& content);

/// Reads the points of all pieces of PolyData (VTP) and UnstructuredGrid (VTU), with size and identity from the point
/// data: ASCII, inline base64, appended raw or base64, with zlib or without, any byte order and header. Other kinds of
/// data set are refused.
Series open_vtk_xml(const Content& content, const ReadOptions& options);

inline constexpr Reader vtk_xml_reader = {"vtk-xml", "points in XML VTK files (.vtp, .vtu)", is_vtk_xml, open_vtk_xml};

}  // namespace recoat
