#pragma once

#include "analyzer/readers/reader.hpp"

namespace recoat {

/// Whether the file is a data file of LAMMPS or LIGGGHTS.
bool is_lammps_data(const Content& content);

/// Reads the section Atoms of a data file as write_data makes it. Of the atom styles, sphere (granular) and bpm/sphere,
/// which have diameter and density, and atomic, charge, bond, angle, molecular, full, which have no size. The style is
/// that behind "Atoms #", or of the options; it is never guessed. A direction with an image flag that is not zero is
/// periodic; otherwise the file does not say. Tilted boxes are refused. What follows a # is a comment.
Series open_lammps_data(const Content& content, const ReadOptions& options);

inline constexpr Reader lammps_data_reader = {"lammps-data", "data files of LAMMPS and LIGGGHTS (write_data)",
                                              is_lammps_data, open_lammps_data};

}  // namespace recoat
