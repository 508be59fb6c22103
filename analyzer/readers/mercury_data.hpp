#pragma once

#include "analyzer/readers/reader.hpp"

namespace recoat {

/// Whether the file is a .data file of MercuryDPM: a line of 8 numbers, the first a count, then lines of 14.
bool is_mercury_data(const Content& content);

/// Reads a snapshot of a .data file in three dimensions: a line "N time xmin ymin zmin xmax ymax zmax", then N lines
/// "x y z vx vy vz radius ..." of 14 numbers. Snapshots count from 0; the file does not say what is periodic. Files in
/// two dimensions (lines of 8 numbers) are refused.
Series open_mercury_data(const Content& content, const ReadOptions& options);

inline constexpr Reader mercury_data_reader = {"mercury-data", "data files of MercuryDPM (.data)", is_mercury_data,
                                               open_mercury_data};

}  // namespace recoat
