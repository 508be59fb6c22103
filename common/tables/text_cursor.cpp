#include "common/tables/text_cursor.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>

#include "common/error.hpp"
#include "common/number.hpp"

namespace recoat {
namespace {

constexpr std::string_view white_space = " \t\r\v\f";

constexpr bool is_white_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r' && c != '\n'); }

}  // namespace

bool TextCursor::next() {
    if (rest_.empty()) return false;
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    has_line_end_ = end < rest_.size();
    line_ = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++number_;
    return true;
}

bool TextCursor::next_filled() {
    while (next()) {
        if (line_.find_first_not_of(white_space) != std::string_view::npos) return true;
    }
    return false;
}

void TextCursor::need(std::string_view wanted) {
    if (next()) return;
    fail(fmt::format("the file ends here, but {} should follow; copy the file again from where it was made", wanted));
}

void TextCursor::need_line_end() const {
    if (has_line_end_ || line_.find_first_not_of(white_space) == std::string_view::npos) return;
    fail("the file ends inside this line, so its last value may be cut; copy the file again from where it was made");
}

void TextCursor::drop_front(std::string_view characters) {
    const auto drops = [&](char c) { return is_white_space(c) || characters.find(c) != std::string_view::npos; };
    while (!line_.empty() && drops(line_.front())) line_.remove_prefix(1);
}

void TextCursor::split(char separator) {
    cells_.clear();
    std::string_view line = line_;
    while (separator != ' ') {
        const std::size_t end = line.find(separator);
        cells_.push_back(trimmed(line.substr(0, end)));
        if (end == std::string_view::npos) return;
        line.remove_prefix(end + 1);
    }
    // By hand: the search for one of several characters takes a call for each of the text.
    const char *place = line.data(), *end = line.data() + line.size();
    while (true) {
        while (place != end && is_white_space(*place)) ++place;
        if (place == end) return;
        const char* start = place;
        while (place != end && !is_white_space(*place)) ++place;
        cells_.emplace_back(start, static_cast<std::size_t>(place - start));
    }
}

void TextCursor::split_quoted(char separator) {
    constexpr char quote = '"';
    if (line_.find(quote) == std::string_view::npos) return split(separator);
    cells_.clear();
    std::string_view rest = line_;
    while (true) {
        const std::size_t start = rest.find_first_not_of(separator == '\t' ? " \r\v\f" : white_space);
        if (start == std::string_view::npos && separator == ' ') return;
        rest.remove_prefix(std::min(start, rest.size()));
        const std::size_t closing = rest.starts_with(quote) ? rest.find(quote, 1) : std::string_view::npos;
        if (closing != std::string_view::npos) {
            cells_.push_back(trimmed(rest.substr(1, closing - 1)));
            rest.remove_prefix(closing + 1);
        }
        const std::size_t end = separator == ' ' ? rest.find_first_of(white_space) : rest.find(separator);
        if (closing == std::string_view::npos) cells_.push_back(trimmed(rest.substr(0, end)));
        if (end == std::string_view::npos) return;
        rest.remove_prefix(end + 1);
    }
}

double TextCursor::any_number(std::size_t column, std::string_view column_name) const {
    const auto value = parse_number(cells_[column]);
    if (!value) fail_at(column, column_name, "this is no number");
    return *value;
}

double TextCursor::number(std::size_t column, std::string_view column_name) const {
    const double value = any_number(column, column_name);
    if (!std::isfinite(value)) fail_at(column, column_name, "the number is not finite");
    return value;
}

double TextCursor::size(std::size_t column, std::string_view column_name, bool allow_zero) const {
    const double value = number(column, column_name);
    if (value < 0) fail_at(column, column_name, "a particle must have a size above zero");
    if (value == 0 && !allow_zero) {
        fail_at(column, column_name,
                "a particle must have a size above zero (--skip-size-zero leaves such particles out)");
    }
    return value;
}

Vec3 TextCursor::vector(const std::array<std::size_t, 3>& columns, std::span<const std::string> names) const {
    return {number(columns[0], names[columns[0]]), number(columns[1], names[columns[1]]),
            number(columns[2], names[columns[2]])};
}

Vec3 TextCursor::any_vector(const std::array<std::size_t, 3>& columns, std::span<const std::string> names) const {
    return {any_number(columns[0], names[columns[0]]), any_number(columns[1], names[columns[1]]),
            any_number(columns[2], names[columns[2]])};
}

std::int64_t TextCursor::integer(std::size_t column, std::string_view column_name) const {
    const auto value = parse_integer(cells_[column]);
    if (!value) fail_at(column, column_name, "this is no whole number");
    return *value;
}

std::size_t TextCursor::count(std::string_view what) const {
    const auto value = parse_integer(trimmed(line_));
    if (!value || *value < 0) {
        fail(fmt::format("\"{}\" is no {}; copy the file again from where it was made", quotable(line_), what));
    }
    return static_cast<std::size_t>(*value);
}

void TextCursor::fail(const std::string& problem) const {
    throw InputError(fmt::format("{}:{}: {}", name_, std::max<std::size_t>(number_, 1), problem));
}

void TextCursor::fail_at(std::size_t column, std::string_view column_name, const std::string& problem) const {
    fail(fmt::format("column {} ({}): \"{}\": {}; correct the value or remove the line", column + 1,
                     quotable(column_name), quotable(cells_[column]), problem));
}

std::string quotable(std::string_view text) {
    constexpr std::size_t longest_quote = 40;
    std::string result(text.substr(0, longest_quote));
    std::ranges::replace_if(
        result, [](unsigned char c) { return std::iscntrl(c) || c >= 0x80; }, '?');
    return result;
}

std::string quotable_list(std::span<const std::string> names) {
    constexpr std::size_t longest_list = 20;
    std::string list;
    for (const std::string& name : names.first(std::min(names.size(), longest_list))) {
        list += (list.empty() ? "" : ", ") + quotable(name);
    }
    return names.size() > longest_list ? list + ", ..." : list;
}

std::string lower_case(std::string_view text) {
    std::string result(text);
    std::ranges::transform(result, result.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

bool looks_like_text(std::string_view head) {
    return head.find('\0') == std::string_view::npos && !head.starts_with('\x89');
}

}  // namespace recoat
