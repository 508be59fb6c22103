#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analyzer/readers/source.hpp"
#include "common/tables/text_cursor.hpp"

namespace recoat {

/// Units of a LAMMPS unit style.
struct LammpsUnits {
    std::string style;             ///< its name, or empty
    std::optional<double> length;  ///< [m]; nothing where the style has no unit of length ("lj") or is not named
    double time = 1;               ///< [s]

    /// Whether velocities have a meaning: the style is known, or none is named.
    [[nodiscard]] bool known() const { return style.empty() || length.has_value(); }
};

/// Units of a style ("si", "micro", ...); without length for "lj" and unknown ones.
[[nodiscard]] LammpsUnits lammps_units(std::string_view style);

/// What stands before the atoms of one snapshot of a LAMMPS dump.
struct LammpsSnapshot {
    std::int64_t step = 0;
    std::optional<double> time;        ///< as the dump has it
    std::size_t count = 0;             ///< atoms
    Box box;                           ///< in the unit of the dump
    LammpsUnits units;                 ///< as the dump names them
    std::vector<std::string> columns;  ///< names, in small letters
};

/// Reads the items up to and with the names of the columns; the cursor stands on the first of these lines and ends on
/// the last. The unit is named in the first snapshot only: later ones take it from `previous`.
/// @throws InputError when it is damaged, of a tilted box, or no list of atoms.
[[nodiscard]] LammpsSnapshot read_lammps_header(TextCursor& cursor, const LammpsSnapshot* previous);

}  // namespace recoat
