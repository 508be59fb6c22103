#include "analyzer/readers/xyz_comment.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "analyzer/readers/tilt.hpp"
#include "common/number.hpp"

namespace recoat {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

/// The closing mark for a value that begins with this character, or 0.
char closing_of(char c) {
    switch (c) {
        case '"':
        case '\'':
            return c;
        case '{':
            return '}';
        case '[':
            return ']';
        default:
            return 0;
    }
}

/// Place of the mark that closes the one at the beginning, which may have others of its kind inside.
std::size_t end_of_enclosed(std::string_view text) {
    const char opening = text[0], closing = closing_of(opening);
    int depth = 1;
    for (std::size_t i = 1; i < text.size(); ++i) {
        if (text[i] == closing) {
            if (--depth == 0) return i;
        } else if (text[i] == opening) {
            ++depth;
        }
    }
    return text.size();
}

/// Takes a value off the front of the text.
std::string take_value(std::string_view& text) {
    std::size_t end = 0;
    if (!text.empty() && closing_of(text[0]) != 0) {
        end = end_of_enclosed(text);
        std::string value(text.substr(1, end - 1));
        text.remove_prefix(std::min(end + 1, text.size()));
        return value;
    }
    while (end < text.size() && !is_blank(text[end])) ++end;
    std::string value(text.substr(0, end));
    text.remove_prefix(end);
    return value;
}

/// Words between blanks, commas and brackets: "4 2 3", or [[4, 0, 0], [0, 2, 0], [0, 0, 3]].
std::vector<std::string> words_of(std::string text) {
    std::ranges::replace_if(
        text, [](char c) { return c == ',' || c == '[' || c == ']'; }, ' ');
    TextCursor words({}, text);
    if (words.next()) words.split();
    return {words.cells().begin(), words.cells().end()};
}

std::vector<double> numbers_of(const TextCursor& cursor, const std::string& key, const std::string& text) {
    std::vector<double> numbers;
    for (const std::string& word : words_of(text)) {
        const auto number = parse_number(word);
        if (!number || !std::isfinite(*number)) {
            cursor.fail(fmt::format("\"{}\" in {} is no finite number; correct it", quotable(word), key));
        }
        numbers.push_back(*number);
    }
    return numbers;
}

/// The three flags, each T, F, 1, 0, true or false; none where nothing is said.
std::array<bool, 3> periodic_of(const TextCursor& cursor, const std::string& text) {
    constexpr std::array<std::string_view, 3> yes = {"t", "1", "true"}, no = {"f", "0", "false"};
    std::array<bool, 3> periodic = {};
    const std::vector<std::string> words = words_of(lower_case(text));
    const auto known = [&](const std::string& word) {
        return std::ranges::find(yes, word) != yes.end() || std::ranges::find(no, word) != no.end();
    };
    if (words.empty()) return periodic;
    if (words.size() != 3 || !std::ranges::all_of(words, known)) {
        cursor.fail(
            fmt::format("\"{}\" in pbc is not three of T and F, as in pbc=\"F T F\"; correct it", quotable(text)));
    }
    for (std::size_t a = 0; a < 3; ++a) periodic[a] = std::ranges::find(yes, words[a]) != yes.end();
    return periodic;
}

std::vector<std::string_view> parts_of(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    while (true) {
        const std::size_t end = text.find(separator);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos) return parts;
        text.remove_prefix(end + 1);
    }
}

}  // namespace

std::string XyzComment::value(const std::string& key) const {
    const auto found = values.find(key);
    return found == values.end() ? std::string() : found->second;
}

XyzComment parse_xyz_comment(std::string_view line) {
    XyzComment comment;
    while (!line.empty()) {
        if (is_blank(line[0])) {
            line.remove_prefix(1);
            continue;
        }
        std::size_t end = 0;
        while (end < line.size() && line[end] != '=' && !is_blank(line[end])) ++end;
        const std::string key = lower_case(line.substr(0, end));
        line.remove_prefix(end);
        if (line.starts_with('=')) {
            line.remove_prefix(1);
            comment.values[key] = take_value(line);
        } else if (key == "timestep:") {  // the plain XYZ of LAMMPS: "Atoms. Timestep: 1000"
            line = trimmed(line);
            comment.values["timestep"] = take_value(line);
        }
    }
    return comment;
}

std::vector<std::string> xyz_columns(const XyzComment& comment, const TextCursor& cursor) {
    const std::string properties = comment.value("properties");
    if (properties.empty()) return {"species", "pos:0", "pos:1", "pos:2"};
    const std::vector<std::string_view> parts = parts_of(properties, ':');
    std::vector<std::string> columns;
    constexpr std::int64_t most_columns = 1000;
    for (std::size_t i = 0; i < parts.size(); i += 3) {
        const std::int64_t count = i + 2 < parts.size() ? parse_integer(parts[i + 2]).value_or(0) : 0;
        const bool known_type = i + 1 < parts.size() && parts[i + 1].size() == 1 &&
                                std::string_view("SRILsril").find(parts[i + 1][0]) != std::string_view::npos;
        if (count < 1 || count > most_columns || !known_type) {
            cursor.fail(
                fmt::format("\"{}\" in Properties is not NAME:TYPE:COLUMNS with the type S, R, I or L; correct it",
                            quotable(parts[i])));
        }
        const std::string name = lower_case(parts[i]);
        for (std::int64_t c = 0; c < count; ++c) columns.push_back(count == 1 ? name : fmt::format("{}:{}", name, c));
        if (columns.size() > most_columns) cursor.fail("Properties names more than a thousand columns; correct it");
    }
    return columns;
}

std::optional<Box> xyz_box(const XyzComment& comment, const TextCursor& cursor) {
    const std::string text = comment.value("lattice");
    if (text.empty()) return {};
    const std::vector<double> lattice = numbers_of(cursor, "Lattice", text);
    if (lattice.size() != 9 && lattice.size() != 3) {
        cursor.fail(fmt::format("Lattice has {} numbers, but the sides of a box are 9; correct it", lattice.size()));
    }
    Vec3 sides = {lattice[0], lattice[1], lattice[2]};
    if (lattice.size() == 9) {
        sides = {lattice[0], lattice[4], lattice[8]};
        for (const std::size_t i : {1U, 2U, 3U, 5U, 6U, 7U}) {
            require_no_tilt(cursor, lattice[i], lattice[i / 3 * 4]);
        }
    }
    const std::vector<double> origin = numbers_of(cursor, "Origin", comment.value("origin"));
    if (!origin.empty() && origin.size() != 3) {
        cursor.fail(fmt::format("Origin has {} numbers instead of 3; correct it", origin.size()));
    }
    Box box;
    if (!origin.empty()) box.lower = {origin[0], origin[1], origin[2]};
    box.upper = {box.lower.x + sides.x, box.lower.y + sides.y, box.lower.z + sides.z};
    box.periodic = periodic_of(cursor, comment.value("pbc"));
    box.unwrapped = box.periodic;
    return box;
}

}  // namespace recoat
