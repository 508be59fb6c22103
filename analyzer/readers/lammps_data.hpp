#pragma once

#include "analyzer/readers/reader.hpp"

namespace recoat {

/// Whether the file is a data file of LAMMPS or LIGGGHTS.
bool is_lammps_data(const Content& content);

/// Reads the section Atoms of a data file as write_data makes it. Of the atom styles, sphere (granular), which has
/// diameter and density, and atomic, charge, bond, molecular, full, which have no size. Without a comment that names
/// the style, 7 columns (10 with image flags) are sphere and 5 (8) atomic. A direction with an image flag that is not
/// zero is periodic; otherwise the file does not say. Tilted boxes are refused.
Series open_lammps_data(const Content& content, const ReadOptions& options);

inline constexpr Reader lammps_data_reader = {"lammps-data", "data files of LAMMPS and LIGGGHTS (write_data)",
                                              is_lammps_data, open_lammps_data};

}  // namespace recoat
