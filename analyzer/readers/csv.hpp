#pragma once

#include "analyzer/readers/reader.hpp"

namespace recoat {

/// Whether the file is text whose first line names columns.
bool is_csv(const std::filesystem::path& file, std::string_view head);

/// Reads a table: the first line names the columns, in any order; the columns x, y, z and radius (or r, diameter, d)
/// are taken, in metres, and others passed over. Separators are commas, semicolons or white space. Empty lines count
/// for nothing.
Source read_csv(const std::filesystem::path& file, const ColumnNames& columns);

inline constexpr Reader csv_reader = {
    "csv", "tables of text with a first line that names the columns x, y, z and radius or diameter (CSV)", is_csv,
    read_csv};

}  // namespace recoat
