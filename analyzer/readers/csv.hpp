#pragma once

#include "analyzer/readers/reader.hpp"

namespace recoat {

/// Whether the file is text.
bool is_csv(const Content& content);

/// Reads a table by the rules of read_csv_table(); where no length has a unit, all are in that of the options, or in
/// metres.
Series open_csv(const Content& content, const ReadOptions& options);

inline constexpr Reader csv_reader = {
    "csv", "tables of text with a first line that names the columns x, y, z and radius or diameter (CSV)", is_csv,
    open_csv};

}  // namespace recoat
