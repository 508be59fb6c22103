#pragma once

#include "analyzer/readers/reader.hpp"

namespace recoat {

/// Whether the file is XYZ: a count, a comment with Properties, or particles that begin with a word.
bool is_extended_xyz(const Content& content);

/// Reads the frames of extended XYZ (exaDEM, LAMMPS, OVITO, ASE): columns as Properties names them, the box of Lattice,
/// Origin and pbc. Plain XYZ has a word and the position. The numbers of the time steps are those of the key Timestep
/// or Step where every frame has one, else they count from 0.
Series open_extended_xyz(const Content& content, const ReadOptions& options);

inline constexpr Reader extended_xyz_reader = {"extended-xyz", "extended XYZ of exaDEM, LAMMPS, OVITO, ASE (.xyz)",
                                               is_extended_xyz, open_extended_xyz};

}  // namespace recoat
