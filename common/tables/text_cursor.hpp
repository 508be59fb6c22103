#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/vec3.hpp"

namespace recoat {

/// Goes through a text line by line and knows where it is, for errors. Columns count from 0 here, from 1 in errors.
class TextCursor {
public:
    /// `name` stands for the file in errors; `text` must outlive the cursor.
    TextCursor(std::string name, std::string_view text) : name_(std::move(name)), rest_(text) {}

    /// Moves to the next line; false at the end of the text.
    bool next();
    /// Moves to the next line that is not blank; false when there is none.
    bool next_filled();
    /// Moves to the next line, blank or not. Throws InputError when the text ends before `wanted`.
    void need(std::string_view wanted);

    /// Throws InputError when the text ends inside the line, whose last number may then be cut. Blank lines do not
    /// count.
    void need_line_end() const;
    /// Whether a line end follows the line; else the text ends with it.
    [[nodiscard]] bool has_line_end() const { return has_line_end_; }
    /// Takes white space and these characters off the beginning of the line.
    void drop_front(std::string_view characters);
    /// Takes this character and what follows it off the line, as a comment.
    void drop_comment(char mark) { line_ = line_.substr(0, line_.find(mark)); }

    [[nodiscard]] std::string_view line() const { return line_; }
    [[nodiscard]] std::size_t line_number() const { return number_; }
    [[nodiscard]] std::string_view rest() const { return rest_; }
    [[nodiscard]] const std::string& name() const { return name_; }

    /// Cuts the line into cells(); `separator` ' ' stands for any white space.
    void split(char separator = ' ');
    /// The same, but cells may stand in double quotes, with separators in them; the quotes are taken off.
    void split_quoted(char separator);
    [[nodiscard]] const std::vector<std::string_view>& cells() const { return cells_; }

    /// The finite number in a cell; `column_name` is for the error.
    [[nodiscard]] double number(std::size_t column, std::string_view column_name) const;
    /// The finite numbers in three cells.
    [[nodiscard]] Vec3 vector(const std::array<std::size_t, 3>& columns, std::span<const std::string> names) const;
    /// The numbers in three cells, which may be infinite or no numbers (nan).
    [[nodiscard]] Vec3 any_vector(const std::array<std::size_t, 3>& columns, std::span<const std::string> names) const;
    /// The size in a cell: a finite number above zero, or zero where that is allowed.
    [[nodiscard]] double size(std::size_t column, std::string_view column_name, bool allow_zero) const;
    /// The whole number in a cell.
    [[nodiscard]] std::int64_t integer(std::size_t column, std::string_view column_name) const;
    /// The whole number that is all of the line and not negative, e.g. a count; `what` is for the error.
    [[nodiscard]] std::size_t count(std::string_view what) const;

    /// Throws InputError "file:line: problem".
    [[noreturn]] void fail(const std::string& problem) const;
    /// Throws InputError that names and quotes a cell.
    [[noreturn]] void fail_at(std::size_t column, std::string_view column_name, const std::string& problem) const;

private:
    [[nodiscard]] double any_number(std::size_t column, std::string_view column_name) const;

    std::string name_;
    std::string_view rest_, line_;
    std::size_t number_ = 0;
    bool has_line_end_ = true;
    std::vector<std::string_view> cells_;
};

/// The beginning of a text as it can be shown in a sentence: without what cannot be printed.
[[nodiscard]] std::string quotable(std::string_view text);

/// Names as they can be listed in a sentence: quotable, and not too many.
[[nodiscard]] std::string quotable_list(std::span<const std::string> names);

/// In small letters (ASCII).
[[nodiscard]] std::string lower_case(std::string_view text);

/// Whether these bytes may be the beginning of a text.
[[nodiscard]] bool looks_like_text(std::string_view head);

}  // namespace recoat
