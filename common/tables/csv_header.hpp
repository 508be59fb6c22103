#pragma once

#include "common/tables/header.hpp"
#include "common/tables/text_cursor.hpp"

namespace recoat {

/// What stands before the rows of a table of text, and how its rows are cut.
struct CsvHeader {
    Header columns;
    char separator = ',';  ///< of the rows; ' ' stands for any white space
};

/// Reads the line that names the columns, and what may stand around it: "sep=;" as Excel writes it, comments, which
/// begin with # or %, and a row of units. The line may be a comment itself. The cursor ends before the first row.
/// @throws InputError when no line names the columns of the coordinates, by names that are usual or chosen.
[[nodiscard]] CsvHeader read_csv_header(TextCursor& cursor, const ColumnNames& chosen);

/// Whether the line is a comment of a table.
[[nodiscard]] bool is_csv_comment(std::string_view line);

/// Value of a number that may be written with a decimal comma, or nothing.
[[nodiscard]] std::optional<double> parse_number_with_comma(std::string_view text);

}  // namespace recoat
