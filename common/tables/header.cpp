#include "common/tables/header.hpp"

#include <algorithm>
#include <cctype>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include "common/number.hpp"
#include "common/tables/text_cursor.hpp"
#include "common/text_encoding.hpp"

namespace recoat {
namespace {

/// Number of a component in brackets, or its letter.
bool is_component(std::string_view text) {
    const auto is_digit = [](unsigned char c) { return std::isdigit(c) != 0; };
    return text.empty() || text == "x" || text == "y" || text == "z" || std::ranges::all_of(text, is_digit);
}

/// Cuts "x [mm]" into its name and the symbol in the brackets, which is empty where there is none.
std::pair<std::string, std::string> split_symbol(const std::string& name) {
    for (const char* brackets : {"[]", "()"}) {
        const std::size_t open = name.rfind(brackets[0]);
        if (open == std::string::npos || open == 0 || name.back() != brackets[1]) continue;
        const std::string_view symbol = trimmed(std::string_view(name).substr(open + 1, name.size() - open - 2));
        if (is_component(symbol)) continue;
        const std::string_view bare = trimmed(std::string_view(name).substr(0, open));
        return {std::string(bare), symbol == "-" ? std::string() : std::string(symbol)};
    }
    return {name, {}};
}

/// Whether the symbol is one of this dimension; else why not.
std::optional<std::string> problem_of(const std::string& symbol, Dimension dimension) {
    try {
        (void)parse_quantity("1 " + quotable(symbol), dimension);
    } catch (const UnitError& error) {
        return error.what();
    }
    return {};
}

std::size_t coordinate(Header& header, char axis, const std::string& chosen) {
    if (!chosen.empty()) return header.choose(chosen);
    if (const auto column = find_coordinate(header.bare_names(), axis)) return *column;
    throw ColumnError(
        fmt::format("there is no column \"{}\" among those of the file ({})", axis, quotable_list(header.names())));
}

}  // namespace

std::optional<ColumnUnit> column_unit(std::string_view written) {
    const std::string symbol = in_utf8(written);
    for (const Dimension dimension : {Dimension::length, Dimension::speed, Dimension::angular_velocity}) {
        try {
            return ColumnUnit{dimension, parse_quantity(fmt::format("1 {}", symbol), dimension)};
        } catch (const UnitError&) {
            continue;
        }
    }
    return {};
}

Header::Header(std::span<const std::string> names) {
    for (const std::string& name : names) {
        names_.push_back(lower_case(in_utf8(name)));
        auto [bare, symbol] = split_symbol(names_.back());
        bare_names_.push_back(std::move(bare));
        symbols_.push_back(std::move(symbol));
    }
    // "x [mm]" beside "x [in]": neither is x without a word more.
    std::unordered_map<std::string, std::size_t> count;
    for (const std::string& bare : bare_names_) ++count[bare];
    for (std::size_t i = 0; i < size(); ++i) {
        if (count[bare_names_[i]] > 1) bare_names_[i] = names_[i];
    }
}

std::size_t Header::choose(std::string_view name) {
    if (const auto column = find_column(names_, name)) {
        // What stands in its brackets is a part of this name, unless it is a unit.
        if (!column_unit(symbols_[*column])) symbols_[*column].clear();
        return *column;
    }
    if (const auto column = find_column(bare_names_, name)) return *column;
    throw ColumnError(
        fmt::format("there is no column \"{}\" among those of the file ({})", quotable(name), quotable_list(names_)));
}

void Header::set_unit(std::size_t column, std::string_view symbol) {
    if (symbols_[column].empty()) symbols_[column] = symbol;
}

double Header::factor(std::size_t column, Dimension dimension) const {
    const std::string& symbol = symbols_[column];
    if (std::ranges::count(names_, names_[column]) > 1) {
        throw ColumnError(
            fmt::format("the column \"{}\" is named twice; give every column its own name", quotable(names_[column])));
    }
    if (symbol.empty()) return 1;
    const auto unit = column_unit(symbol);
    if (unit && unit->dimension == dimension) return unit->factor;
    throw ColumnError(fmt::format("the unit of the column \"{}\" is none of {}: {}", quotable(names_[column]),
                                  dimension_name(dimension), problem_of(symbol, dimension).value_or("correct it")));
}

std::optional<SizeColumn> choose_size(Header& header, const ColumnNames& chosen) {
    if (!chosen.radius.empty()) return SizeColumn{header.choose(chosen.radius), 1.0};
    if (!chosen.diameter.empty()) return SizeColumn{header.choose(chosen.diameter), 0.5};
    return find_usual_size(header.bare_names());
}

ParticleColumns find_particle_columns(Header& header, const ColumnNames& chosen) {
    ParticleColumns columns;
    columns.position = {coordinate(header, 'x', chosen.x), coordinate(header, 'y', chosen.y),
                        coordinate(header, 'z', chosen.z)};
    columns.size = choose_size(header, chosen);
    columns.id = find_id(header.bare_names());
    columns.type = chosen.type.empty() ? find_usual_type(header.bare_names()) : header.choose(chosen.type);
    columns.velocity = find_velocity(header.bare_names());
    columns.angular_velocity = find_angular_velocity(header.bare_names());
    return columns;
}

bool lengths_have_units(const Header& header, std::span<const std::size_t> lengths) {
    const auto has_unit = [&](std::size_t column) { return header.has_unit(column); };
    const auto with = std::ranges::find_if(lengths, has_unit), without = std::ranges::find_if_not(lengths, has_unit);
    if (with == lengths.end()) return false;
    if (without == lengths.end()) return true;
    throw ColumnError(
        fmt::format("the column \"{}\" names no unit, but \"{}\" does; name the unit of every length, or of none",
                    quotable(header.names()[*without]), quotable(header.names()[*with])));
}

}  // namespace recoat
