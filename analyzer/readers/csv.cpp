#include "analyzer/readers/csv.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>

#include <fmt/format.h>

#include "common/error.hpp"
#include "common/number.hpp"

namespace recoat {
namespace {

constexpr std::string_view white_space = " \t\r\v\f";
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// Takes the text up to the next line end off `rest`.
std::string_view take_line(std::string_view& rest) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    return line;
}

/// Cuts a line into cells; `separator` ' ' stands for any white space.
void split(std::string_view line, char separator, std::vector<std::string_view>& cells) {
    cells.clear();
    if (separator != ' ') {
        while (true) {
            const std::size_t end = line.find(separator);
            cells.push_back(trimmed(line.substr(0, end)));
            if (end == std::string_view::npos) return;
            line.remove_prefix(end + 1);
        }
    }
    for (std::size_t start = line.find_first_not_of(white_space); start != std::string_view::npos;) {
        const std::size_t end = std::min(line.find_first_of(white_space, start), line.size());
        cells.push_back(line.substr(start, end - start));
        start = line.find_first_not_of(white_space, end);
    }
}

char separator_of(std::string_view header) {
    for (const char candidate : {';', ','}) {
        if (header.find(candidate) != std::string_view::npos) return candidate;
    }
    return ' ';
}

std::string lower_case(std::string_view text) {
    std::string result(text);
    std::ranges::transform(result, result.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

/// Name of a column as in the header: without quotes around it.
std::string_view unquoted(std::string_view name) {
    const bool quoted =
        name.size() >= 2 && name.front() == name.back() && (name.front() == '"' || name.front() == '\'');
    return quoted ? name.substr(1, name.size() - 2) : name;
}

/// Reads one table; knows where it is, for errors.
class TableReader {
public:
    TableReader(std::string file, std::string_view text) : file_(std::move(file)), rest_(text) {}

    Source read(const ColumnNames& columns) {
        read_header();
        const std::size_t x = required("x", columns.x), y = required("y", columns.y), z = required("z", columns.z);
        const auto [size, size_to_radius] = size_column(columns);
        Source source;
        while (next_line()) {
            split(line_, separator_, cells_);
            if (cells_.size() != names_.size()) {
                fail(fmt::format("the line has {} columns, the first line names {}; make them agree", cells_.size(),
                                 names_.size()));
            }
            source.position.push_back({number(x), number(y), number(z)});
            source.radius.push_back(size_to_radius * number(size));
            if (!(source.radius.back() > 0)) fail_at(size, "a particle must have a size above zero");
        }
        return source;
    }

private:
    /// Moves to the next line that is not empty.
    bool next_line() {
        while (!rest_.empty()) {
            line_ = take_line(rest_);
            ++line_number_;
            if (line_.find_first_not_of(white_space) != std::string_view::npos) return true;
        }
        return false;
    }

    void read_header() {
        if (rest_.starts_with(byte_order_mark)) rest_.remove_prefix(byte_order_mark.size());
        if (!next_line())
            throw InputError(fmt::format("{}: the file has no lines of text; give a table of particles", file_));
        std::string_view header = trimmed(line_);
        if (header.starts_with('#')) header = trimmed(header.substr(1));
        separator_ = separator_of(header);
        split(header, separator_, cells_);
        for (const std::string_view cell : cells_) {
            const std::string name = lower_case(unquoted(cell));
            if (std::ranges::find(names_, name) != names_.end()) {
                fail(fmt::format("the column \"{}\" is named twice; give every column its own name", name));
            }
            names_.push_back(name);
        }
    }

    [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const {
        const auto found = std::ranges::find(names_, lower_case(name));
        if (found == names_.end()) return {};
        return static_cast<std::size_t>(found - names_.begin());
    }

    [[nodiscard]] std::size_t required(std::string_view usual, const std::string& chosen) const {
        const std::string_view name = chosen.empty() ? usual : std::string_view(chosen);
        if (const auto column = find(name)) return *column;
        fail(fmt::format(
            "there is no column \"{}\"; the first line must name it, or the configuration another one under columns.{}",
            name, usual));
    }

    /// Column of the size, and what to multiply it with to get the radius.
    [[nodiscard]] std::pair<std::size_t, double> size_column(const ColumnNames& columns) const {
        if (!columns.radius.empty()) return {required("radius", columns.radius), 1.0};
        if (!columns.diameter.empty()) return {required("diameter", columns.diameter), 0.5};
        constexpr std::array<std::pair<std::string_view, double>, 4> usual = {
            {{"radius", 1.0}, {"r", 1.0}, {"diameter", 0.5}, {"d", 0.5}}};
        for (const auto& [name, to_radius] : usual) {
            if (const auto column = find(name)) return {*column, to_radius};
        }
        fail(
            "there is no column \"radius\" or \"diameter\"; the first line must name one, or the configuration another "
            "one under columns");
    }

    [[nodiscard]] double number(std::size_t column) const {
        const auto value = parse_number(cells_[column]);
        if (!value) fail_at(column, "this is no number");
        if (!std::isfinite(*value)) fail_at(column, "the number is not finite");
        return *value;
    }

    [[noreturn]] void fail(const std::string& problem) const {
        throw InputError(fmt::format("{}:{}: {}", file_, std::max<std::size_t>(line_number_, 1), problem));
    }

    [[noreturn]] void fail_at(std::size_t column, const std::string& problem) const {
        constexpr std::size_t longest_quote = 40;
        fail(fmt::format("column {} ({}): \"{}\": {}; correct the value or remove the line", column + 1, names_[column],
                         cells_[column].substr(0, longest_quote), problem));
    }

    std::string file_;
    std::string_view rest_, line_;
    std::size_t line_number_ = 0;
    char separator_ = ',';
    std::vector<std::string> names_;
    std::vector<std::string_view> cells_;
};

}  // namespace

bool is_csv(const std::filesystem::path&, std::string_view head) {
    return std::ranges::none_of(head, [](char c) { return c == '\0' || c == '\x89'; });
}

Source read_csv(const std::filesystem::path& file, const ColumnNames& columns) {
    std::ifstream stream(file, std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    return TableReader(file.string(), text).read(columns);
}

}  // namespace recoat
