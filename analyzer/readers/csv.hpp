#pragma once

#include "analyzer/readers/reader.hpp"

namespace recoat {

/// Whether the file is text.
bool is_csv(const Content& content);

/// Reads a table: the first line names the columns, in any order; those of the centre and of the radius or diameter are
/// taken, the identities too, and others passed over. A name may carry a unit of length, "x [um]", "radius (mm)"; then
/// those without are in metres. Separators are commas, semicolons, bars or white space. Empty lines count for
/// nothing.
Series open_csv(const Content& content, const ReadOptions& options);

inline constexpr Reader csv_reader = {
    "csv", "tables of text with a first line that names the columns x, y, z and radius or diameter (CSV)", is_csv,
    open_csv};

}  // namespace recoat
