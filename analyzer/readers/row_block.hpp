#pragma once

#include <string>

#include "common/tables/text_cursor.hpp"

namespace recoat {

/// Rows of numbers of one time step in a text file, all with as many columns.
struct RowBlock {
    std::size_t rows = 0, columns = 0;
    std::string what;  ///< for errors, e.g. "304 atoms of the time step 1000"
};

/// Passes over rows that are read later; the cursor ends on the last. When they are not all there, or something else
/// than the head of another step follows, the line that is to blame is the first among them that is no row, where there
/// is one.
/// @throws InputError naming that line, or that the file ends too early or inside the last line.
void pass_rows(TextCursor& cursor, const RowBlock& block, bool (*is_head)(TextCursor& line));

}  // namespace recoat
