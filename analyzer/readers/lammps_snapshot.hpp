#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analyzer/readers/source.hpp"
#include "analyzer/readers/text_cursor.hpp"

namespace recoat {

/// What stands before the atoms of one snapshot of a LAMMPS dump.
struct LammpsSnapshot {
    std::int64_t step = 0;
    std::size_t count = 0;             ///< atoms
    Box box;                           ///< in the unit of the dump
    std::optional<double> unit;        ///< of length [m], where the dump names it
    std::vector<std::string> columns;  ///< names, in small letters
};

/// Reads the items up to and with the names of the columns; the cursor stands on the first of these lines and ends on
/// the last. The unit is named in the first snapshot only: later ones take it from `previous`.
/// @throws InputError when it is damaged, of a tilted box, or no list of atoms.
[[nodiscard]] LammpsSnapshot read_lammps_header(TextCursor& cursor, const LammpsSnapshot* previous);

/// Length of the unit of a LAMMPS unit style ("si", "micro", ...) [m]; nothing for others.
[[nodiscard]] std::optional<double> lammps_length_unit(std::string_view style);

}  // namespace recoat
