#include "common/tables/csv_header.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "common/error.hpp"
#include "common/number.hpp"

namespace recoat {
namespace {

constexpr std::string_view comment_marks = "#%";
constexpr std::size_t most_columns = 10'000;  // more would take long to compare with each other

using Cells = std::vector<std::string>;

bool is_number(std::string_view cell) {
    return parse_number(cell).has_value() || parse_number_with_comma(cell).has_value();
}

bool is_filled(std::string_view cell) { return !cell.empty(); }

/// The separator that "sep=;" tells.
std::optional<char> told_separator(std::string_view line) {
    std::string_view text = line;
    while (text.ends_with('\r') || text.ends_with('"')) text.remove_suffix(1);
    if (text.starts_with('"')) text.remove_prefix(1);
    constexpr std::string_view mark = "sep=";
    if (text.size() != mark.size() + 1 || lower_case(text.substr(0, mark.size())) != mark) return {};
    return text.back();
}

std::string_view without_quotes(std::string_view name) {
    const bool quoted = name.size() >= 2 && name.front() == name.back() && name.front() == '\'';
    return quoted ? name.substr(1, name.size() - 2) : name;
}

Cells cells_of(TextCursor& cursor, char separator) {
    cursor.split_quoted(separator);
    Cells cells;
    for (const std::string_view cell : cursor.cells()) cells.emplace_back(without_quotes(cell));
    return cells;
}

/// Puts "[um]" back to the name that a blank cut it off from.
void join_units(Cells& names) {
    Cells joined;
    for (std::string& name : names) {
        const bool unit = (name.starts_with('[') || name.starts_with('(')) && !joined.empty();
        if (unit && column_unit(std::string_view(name).substr(1, name.size() - 2))) {
            joined.back() += name;
        } else {
            joined.push_back(std::move(name));
        }
    }
    names = std::move(joined);
}

/// Names of columns in a line, without an empty one behind the last separator, and that separator.
struct Names {
    Cells cells;
    char separator = ',';
};

/// The sign that separates them, or a blank. Blanks beside tabs may be parts of names.
char separator_of(std::string_view line) {
    for (const char candidate : {';', ',', '|', '\t'}) {
        if (line.find(candidate) != std::string_view::npos) return candidate;
    }
    return ' ';
}

Names names_in(TextCursor cursor, std::optional<char> told) {
    Names names;
    names.separator = told.value_or(separator_of(cursor.line()));
    names.cells = cells_of(cursor, names.separator);
    if (names.separator == '\t') {
        const Cells words = cells_of(cursor, ' ');
        if (words.size() == names.cells.size()) names = {words, ' '};
    }
    if (names.separator == ' ') join_units(names.cells);
    while (names.cells.size() > 1 && names.cells.back().empty()) names.cells.pop_back();
    return names;
}

/// The line without the marks of a comment before it.
TextCursor uncommented(const TextCursor& cursor) {
    TextCursor result = cursor;
    result.drop_front(comment_marks);
    return result;
}

bool names_coordinates(const Names& names, const ColumnNames& chosen) {
    if (names.cells.size() > most_columns) return false;
    Header header(names.cells);
    try {
        (void)find_particle_columns(header, chosen);
    } catch (const ColumnError&) {
        return false;
    }
    return true;
}

/// Whether the line is a row of units: a length at least, and no number.
bool is_row_of_units(const Cells& cells) {
    const auto unit_in = [](std::string_view cell) {
        const bool brackets = cell.size() > 2 && (cell.front() == '[' || cell.front() == '(');
        return column_unit(brackets ? cell.substr(1, cell.size() - 2) : cell);
    };
    const auto is_length = [&](std::string_view cell) {
        const auto unit = unit_in(cell);
        return unit && unit->dimension == Dimension::length;
    };
    return std::ranges::none_of(cells, is_number) && std::ranges::any_of(cells, is_length);
}

void take_units(Header& header, const Cells& cells) {
    for (std::size_t i = 0; i < std::min(header.size(), cells.size()); ++i) {
        std::string_view symbol = cells[i];
        if (symbol.starts_with('[') || symbol.starts_with('(')) symbol = symbol.substr(1, symbol.size() - 2);
        if (symbol != "-") header.set_unit(i, symbol);
    }
}

/// The separator by which this row has as many cells as there are columns; rows may be cut otherwise than their header.
char separator_of_rows(TextCursor row, char of_header, std::size_t columns) {
    for (const char candidate : {of_header, ';', ',', '\t', '|', ' '}) {
        row.split_quoted(candidate);
        const auto count = static_cast<std::size_t>(std::ranges::count_if(row.cells(), is_filled));
        if (row.cells().size() == columns || (candidate == of_header && count == columns)) return candidate;
    }
    return of_header;
}

/// Goes through the lines before the first row.
class HeaderReader {
public:
    HeaderReader(TextCursor& cursor, const ColumnNames& chosen) : cursor_(cursor), chosen_(chosen) {}

    CsvHeader read() {
        if (!next()) {
            throw InputError(
                fmt::format("{}: the file has no lines of text; give a table of particles", cursor_.name()));
        }
        if (const auto told = told_separator(cursor_.line())) {
            told_ = told;
            if (!next()) cursor_.fail("no line names the columns; write one, e.g. x,y,z,radius");
        }
        const Names first = find_names();
        Header header(first.cells);
        read_units(header, first.separator);
        TextCursor row = before_;
        while (row.next_filled() && is_csv_comment(row.line())) {
        }
        const char separator = told_.value_or(separator_of_rows(row, first.separator, header.size()));
        cursor_ = before_;
        return {std::move(header), separator};
    }

private:
    /// To the next line; where it began is kept.
    bool next() {
        before_ = cursor_;
        return cursor_.next_filled();
    }

    /// Names in the first line that is no comment, or else in a comment before it. The rows begin behind it.
    Names find_names() {
        std::optional<TextCursor> named;
        bool more = true;
        for (; more && is_csv_comment(cursor_.line()); more = next()) {
            if (names_coordinates(names_in(uncommented(cursor_), told_), chosen_)) named = cursor_;
        }
        if (more && !is_row()) {
            named = cursor_;
        } else if (!named) {
            cursor_.fail(fmt::format("{} no line names the columns; write one above the rows, e.g. x,y,z,radius",
                                     more ? "the rows begin here, but" : "the file ends here, and"));
        }
        before_ = *named;
        Names names = names_in(uncommented(*named), told_);
        if (names.cells.size() <= most_columns) return names;
        cursor_.fail(fmt::format("the line has {} columns, which is no table of particles; give one with less than {}",
                                 names.cells.size(), most_columns));
    }

    /// Whether the line holds numbers.
    [[nodiscard]] bool is_row() const {
        TextCursor line = cursor_;
        line.split_quoted(told_.value_or(separator_of(line.line())));
        return std::ranges::all_of(line.cells(), [](std::string_view cell) { return cell.empty() || is_number(cell); });
    }

    /// Also where names and units stand in comments.
    void read_units(Header& header, char separator) {
        TextCursor row = before_;
        if (!row.next_filled()) return;
        TextCursor content = uncommented(row);
        const Cells cells = cells_of(content, separator);
        if (cells.size() < header.size() || cells.size() > header.size() + 1 || !is_row_of_units(cells)) return;
        take_units(header, cells);
        before_ = row;
    }

    TextCursor& cursor_;
    const ColumnNames& chosen_;
    TextCursor before_ = cursor_;
    std::optional<char> told_;
};

}  // namespace

bool is_csv_comment(std::string_view line) {
    const std::string_view text = trimmed(line);
    return !text.empty() && comment_marks.find(text.front()) != std::string_view::npos;
}

std::optional<double> parse_number_with_comma(std::string_view text) {
    if (text.find('.') != std::string_view::npos) return {};
    std::string with_point(text);
    std::ranges::replace(with_point, ',', '.');
    return parse_number(with_point);
}

CsvHeader read_csv_header(TextCursor& cursor, const ColumnNames& chosen) { return HeaderReader(cursor, chosen).read(); }

}  // namespace recoat
