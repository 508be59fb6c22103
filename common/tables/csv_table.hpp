#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "common/tables/columns.hpp"
#include "common/vec3.hpp"

namespace recoat {

/// What is known of a table before it is read.
struct CsvOptions {
    ColumnNames columns = {};                               ///< that the user chose
    bool needs_size = true;                                 ///< whether there must be a column of the size
    bool allows_size_zero = false;                          ///< for particles of size 0 that are left out later
    bool whole_velocities = false;                          ///< whether a velocity must not lack a component
    std::string_view naming = "name it in the first line";  ///< what to do about a column that is not found
    std::string_view about_size_zero = "a particle must have a size above zero";  ///< why a size of 0 is refused
};

/// Particles from a table of text, in the order of its rows.
struct CsvTable {
    std::vector<Vec3> position;          ///< [N]
    std::vector<double> radius;          ///< [N], or empty
    std::vector<Vec3> velocity;          ///< [N] any numbers, or empty
    std::vector<Vec3> angular_velocity;  ///< [N] any numbers, or empty
    std::vector<std::int64_t> id;        ///< [N], or empty
    std::vector<std::string_view> type;  ///< [N] cells of the text, or empty
    std::vector<std::size_t> line;       ///< [N] lines of the text
    bool has_units = false;              ///< whether units are named and all is in SI units, velocities without one too
    std::vector<std::string> columns;    ///< names of all, in small letters
    std::vector<std::string> unused;     ///< names of columns that were passed over
    std::vector<std::string> warnings;   ///< whole sentences
};

/// Reads a table whose first line names its columns, in any order: centres, radius or diameter, and, where all three
/// components are there, velocities and angular velocities; identities too. Names are usual ones or chosen, and may
/// carry a unit, as "x [um]"; so may a row below them. Cells lie between commas, semicolons, bars, tabs or white space,
/// may be quoted, and numbers may have a decimal comma. Comments (# or %), empty rows and "sep=;" count for nothing.
/// @throws InputError naming `name`, line and column when a column is not there, lengths are named with and without
/// units, a cell is no number, a position or size not finite, a size not above zero, or a row has another number of
/// columns.
[[nodiscard]] CsvTable read_csv_table(const std::string& name, std::string_view text, const CsvOptions& options);

}  // namespace recoat
