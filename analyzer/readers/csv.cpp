#include "analyzer/readers/csv.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "analyzer/readers/columns.hpp"
#include "analyzer/readers/text_cursor.hpp"
#include "common/error.hpp"
#include "common/number.hpp"
#include "common/units.hpp"

namespace recoat {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

char separator_of(std::string_view header) {
    for (const char candidate : {';', ',', '|'}) {
        if (header.find(candidate) != std::string_view::npos) return candidate;
    }
    return ' ';
}

/// Name of a column as in the header: without quotes around it.
std::string_view unquoted(std::string_view name) {
    const bool quoted =
        name.size() >= 2 && name.front() == name.back() && (name.front() == '"' || name.front() == '\'');
    return quoted ? name.substr(1, name.size() - 2) : name;
}

struct Unit {
    Dimension dimension = Dimension::length;
    double factor = 1;  ///< to the SI unit
};

/// The unit of what particles have in columns; nothing for anything else.
std::optional<Unit> unit_of(const std::string& text) {
    for (const Dimension dimension : {Dimension::length, Dimension::speed, Dimension::angular_velocity}) {
        try {
            return Unit{dimension, parse_quantity("1 " + text, dimension)};
        } catch (const UnitError&) {
            continue;  // brackets of another meaning
        }
    }
    return {};
}

/// Takes a unit in brackets off the end of a name; nothing when there is none.
std::optional<Unit> take_unit(std::string& name) {
    for (const char* brackets : {"[]", "()"}) {
        const std::size_t open = name.rfind(brackets[0]);
        if (open == std::string::npos || open == 0 || name.back() != brackets[1]) continue;
        const auto unit = unit_of(name.substr(open + 1, name.size() - open - 2));
        if (unit) name = trimmed(std::string_view(name).substr(0, open));
        return unit;
    }
    return {};
}

/// A header and the columns that it names.
class Table {
public:
    Table(const Content& content, const ReadOptions& options) : cursor_(content.name(), text_of(content)) {
        read_header();
        columns_ = {required('x', options.columns.x), required('y', options.columns.y),
                    required('z', options.columns.z)};
        size_ = find_size(names_, options.columns, [this](const std::string& problem) { cursor_.fail(problem); });
        id_ = find_id(names_);
        type_ = find_type(names_, options.columns, [this](const std::string& problem) { cursor_.fail(problem); });
        velocity_ = find_velocity(names_);
        angular_velocity_ = find_angular_velocity(names_);
        allow_size_zero_ = options.allow_size_zero();
        check_units();
        if (!size_ && !options.radius) {
            cursor_.fail(
                "there is no column \"radius\" or \"diameter\"; the first line must name one, or the configuration "
                "another one under columns, or --radius must give one radius for all");
        }
        has_units_ = std::ranges::any_of(units_, [](const auto& unit) { return unit.has_value(); });
    }

    Source read() {
        Source source;
        while (cursor_.next_filled()) {
            cursor_.split(separator_);
            if (cursor_.cells().size() != names_.size()) {
                cursor_.fail(fmt::format("the line has {} columns, the first line names {}; make them agree",
                                         cursor_.cells().size(), names_.size()));
            }
            source.position.push_back(vector(columns_, Dimension::length));
            if (size_) read_size(source);
            if (id_) source.id.push_back(identity());
            if (velocity_) source.velocity.push_back(any_vector(*velocity_, Dimension::speed));
            if (angular_velocity_) {
                source.angular_velocity.push_back(any_vector(*angular_velocity_, Dimension::angular_velocity));
            }
            if (type_) source.type.add(unquoted(cursor_.cells()[*type_]));
            source.line.push_back(cursor_.line_number());
        }
        if (has_units_) source.own_unit = 1.0;
        source.info.base = 0;
        return source;
    }

private:
    static std::string_view text_of(const Content& content) {
        std::string_view text = content.bytes;
        if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
        return text;
    }

    void read_header() {
        if (!cursor_.next_filled()) {
            throw InputError(
                fmt::format("{}: the file has no lines of text; give a table of particles", cursor_.name()));
        }
        separator_ = separator_of(cursor_.line());
        cursor_.split(separator_);
        constexpr std::size_t most_columns = 10'000;  // more would take long to compare with each other
        if (cursor_.cells().size() > most_columns) {
            cursor_.fail(
                fmt::format("the line has {} columns, which is no table of particles; give one with less than {}",
                            cursor_.cells().size(), most_columns));
        }
        std::vector<std::string> cells(cursor_.cells().begin(), cursor_.cells().end());
        if (cells.front().starts_with('#')) cells.front() = trimmed(std::string_view(cells.front()).substr(1));
        if (cells.front().empty()) cells.erase(cells.begin());
        for (const std::string& cell : cells) add_column(lower_case(unquoted(cell)));
    }

    void add_column(std::string name) {
        // "x [um]" cut at its blank.
        const bool only_unit = separator_ == ' ' && !names_.empty() && (name.starts_with('[') || name.starts_with('('));
        if (only_unit) {
            std::string whole = names_.back() + name;
            if (const auto unit = take_unit(whole)) {
                units_.back() = unit;
                return;
            }
        }
        units_.push_back(take_unit(name));
        if (std::ranges::find(names_, name) != names_.end()) {
            cursor_.fail(
                fmt::format("the column \"{}\" is named twice; give every column its own name", quotable(name)));
        }
        names_.push_back(std::move(name));
    }

    [[nodiscard]] std::size_t required(char axis, const std::string& chosen) const {
        const auto column = chosen.empty() ? find_coordinate(names_, axis) : find_column(names_, chosen);
        if (column) return *column;
        cursor_.fail(
            fmt::format("there is no column \"{}\"; the first line must name it, or the configuration another one "
                        "under columns.{}",
                        chosen.empty() ? std::string(1, axis) : chosen, axis));
    }

    /// The unit that the name of the column has, if any.
    [[nodiscard]] double factor(std::size_t column, Dimension dimension) const {
        const auto& unit = units_[column];
        if (!unit) return 1;
        if (unit->dimension == dimension) return unit->factor;
        cursor_.fail(fmt::format("the unit of the column \"{}\" is none of {}; correct it", quotable(names_[column]),
                                 dimension_name(dimension)));
    }

    void check_units() const {
        const auto check = [this](const VectorColumns& columns, Dimension dimension) {
            for (const std::size_t column : columns) (void)factor(column, dimension);
        };
        check(columns_, Dimension::length);
        if (size_) (void)factor(size_->index, Dimension::length);
        if (velocity_) check(*velocity_, Dimension::speed);
        if (angular_velocity_) check(*angular_velocity_, Dimension::angular_velocity);
    }

    [[nodiscard]] Vec3 vector(const VectorColumns& columns, Dimension dimension) const {
        return in_si(cursor_.vector(columns, names_), columns, dimension);
    }

    [[nodiscard]] Vec3 any_vector(const VectorColumns& columns, Dimension dimension) const {
        return in_si(cursor_.any_vector(columns, names_), columns, dimension);
    }

    [[nodiscard]] Vec3 in_si(Vec3 v, const VectorColumns& columns, Dimension dimension) const {
        return {factor(columns[0], dimension) * v.x, factor(columns[1], dimension) * v.y,
                factor(columns[2], dimension) * v.z};
    }

    void read_size(Source& source) const {
        source.radius.push_back(size_->to_radius * factor(size_->index, Dimension::length) *
                                cursor_.size(size_->index, names_[size_->index], allow_size_zero_));
    }

    /// Some programs write whole numbers as 12.0.
    [[nodiscard]] std::int64_t identity() const {
        const double value = cursor_.number(*id_, names_[*id_]);
        constexpr double largest = 0x1p53;
        if (value != std::floor(value) || std::abs(value) > largest) {
            cursor_.fail_at(*id_, names_[*id_], "this is no whole number");
        }
        return static_cast<std::int64_t>(value);
    }

    TextCursor cursor_;
    char separator_ = ',';
    std::vector<std::string> names_;
    std::vector<std::optional<Unit>> units_;  ///< of the columns
    VectorColumns columns_ = {};
    std::optional<VectorColumns> velocity_, angular_velocity_;
    std::optional<SizeColumn> size_;
    std::optional<std::size_t> id_, type_;
    bool has_units_ = false, allow_size_zero_ = false;
};

}  // namespace

bool is_csv(const Content& content) { return looks_like_text(content.head()); }

Series open_csv(const Content& content, const ReadOptions& options) {
    return single_step([&] { return Table(content, options).read(); });
}

}  // namespace recoat
