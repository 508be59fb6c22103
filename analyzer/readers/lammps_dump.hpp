#pragma once

#include "analyzer/readers/reader.hpp"

namespace recoat {

/// Whether the file is a text dump of LAMMPS or LIGGGHTS.
bool is_lammps_dump(const Content& content);

/// Reads a snapshot of a text dump (dump styles atom and custom): real (x), scaled (xs) and unwrapped (xu, xsu)
/// coordinates; the box with its periodic directions; the unit of length where the dump names it. Tilted boxes and
/// dumps of something else than atoms are refused.
Series open_lammps_dump(const Content& content, const ReadOptions& options);

inline constexpr Reader lammps_dump_reader = {"lammps-dump", "text dumps of LAMMPS and LIGGGHTS (atom, custom)",
                                              is_lammps_dump, open_lammps_dump};

}  // namespace recoat
