#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analyzer/readers/source.hpp"
#include "common/tables/text_cursor.hpp"

namespace recoat {

/// What the second line of a frame of an extended XYZ file says: key=value pairs, values with blanks in quotes,
/// braces or brackets.
struct XyzComment {
    std::map<std::string, std::string> values;  ///< by key, in small letters

    [[nodiscard]] std::string value(const std::string& key) const;
};

/// Takes a comment apart; words without a value are passed over.
[[nodiscard]] XyzComment parse_xyz_comment(std::string_view line);

/// Names of the columns that "Properties=name:type:columns:..." tells, in small letters; "name:0", "name:1", ... where
/// a property has several. Without Properties those of plain XYZ: species, pos:0 ... pos:2. Throws InputError.
[[nodiscard]] std::vector<std::string> xyz_columns(const XyzComment& comment, const TextCursor& cursor);

/// The box of Lattice, Origin and pbc; nothing without a lattice. Throws InputError when it is tilted or no box, or pbc
/// is not three flags.
[[nodiscard]] std::optional<Box> xyz_box(const XyzComment& comment, const TextCursor& cursor);

}  // namespace recoat
