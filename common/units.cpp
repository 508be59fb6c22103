#include "common/units.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "common/number.hpp"

namespace recoat {
namespace {

struct Unit {
    std::string_view symbol;
    Dimension dimension;
    double factor;       ///< value of one unit in SI is factor / divisor;
    double divisor = 1;  ///< a power of ten that a double holds exactly, so that 50 um is the double 5e-5
    bool listed = true;  ///< in sentences
};

constexpr double pi = std::numbers::pi;

// The first unit of each dimension is the SI unit.
constexpr Unit units[] = {
    {"m", Dimension::length, 1},
    {"cm", Dimension::length, 1, 1e2},
    {"mm", Dimension::length, 1, 1e3},
    {"um", Dimension::length, 1, 1e6},
    {"micron", Dimension::length, 1, 1e6, false},
    {"microns", Dimension::length, 1, 1e6, false},
    {"nm", Dimension::length, 1, 1e9},
    {"s", Dimension::time, 1},
    {"min", Dimension::time, 60},
    {"ms", Dimension::time, 1, 1e3},
    {"us", Dimension::time, 1, 1e6},
    {"ns", Dimension::time, 1, 1e9},
    {"m/s", Dimension::speed, 1},
    {"cm/s", Dimension::speed, 1, 1e2},
    {"mm/s", Dimension::speed, 1, 1e3},
    {"um/s", Dimension::speed, 1, 1e6},
    {"m/s2", Dimension::acceleration, 1},
    {"m/s^2", Dimension::acceleration, 1},
    {"kg/m3", Dimension::density, 1},
    {"kg/m^3", Dimension::density, 1},
    {"g/cm3", Dimension::density, 1e3},
    {"g/cm^3", Dimension::density, 1e3},
    {"Pa", Dimension::pressure, 1},
    {"kPa", Dimension::pressure, 1e3},
    {"MPa", Dimension::pressure, 1e6},
    {"GPa", Dimension::pressure, 1e9},
    {"J", Dimension::energy, 1},
    {"mJ", Dimension::energy, 1, 1e3},
    {"uJ", Dimension::energy, 1, 1e6},
    {"nJ", Dimension::energy, 1, 1e9},
    {"pJ", Dimension::energy, 1, 1e12},
    {"fJ", Dimension::energy, 1, 1e15},
    {"aJ", Dimension::energy, 1, 1e18},
    {"zJ", Dimension::energy, 1, 1e21},
    {"eV", Dimension::energy, 1.602176634e-19},
    {"rad", Dimension::angle, 1},
    {"deg", Dimension::angle, pi, 180},
    {"rad/s", Dimension::angular_velocity, 1},
    {"deg/s", Dimension::angular_velocity, pi, 180},
    {"rpm", Dimension::angular_velocity, pi, 30},
    {"N", Dimension::force, 1},
    {"mN", Dimension::force, 1, 1e3},
    {"uN", Dimension::force, 1, 1e6},
    {"nN", Dimension::force, 1, 1e9},
};

constexpr std::string_view diameter_symbol = "dp";

std::string unit_list(Dimension dimension, bool with_diameter) {
    std::string list;
    for (const Unit& unit : units) {
        if (unit.dimension != dimension || !unit.listed) continue;
        list += (list.empty() ? "" : ", ");
        list += unit.symbol;
    }
    return with_diameter ? list + ", dp" : list;
}

/// The symbol with "u" for the micro sign that it may begin with: U+00B5, or the Greek letter U+03BC.
std::string without_micro_sign(std::string_view symbol) {
    std::string result(symbol);
    for (const std::string_view micro : {"\u00B5", "\u03BC"}) {
        if (symbol.starts_with(micro)) result.replace(0, micro.size(), 1, 'u');
    }
    return result;
}

/// Splits "50 um" into the longest leading number and the rest.
std::size_t number_length(std::string_view text) {
    for (std::size_t length = text.size(); length > 0; --length) {
        if (parse_number(text.substr(0, length))) return length;
    }
    return 0;
}

double in_si(double number, std::string_view written, Dimension dimension, std::optional<double> particle_diameter) {
    const std::string symbol = without_micro_sign(written);
    const bool is_length = dimension == Dimension::length;
    if (is_length && symbol == diameter_symbol) {
        if (particle_diameter) return number * *particle_diameter;
        throw UnitError(
            "the unit dp needs a particle diameter, which is not known here; write the length in m, mm or um");
    }
    const auto unit = std::find_if(std::begin(units), std::end(units),
                                   [&](const Unit& u) { return u.symbol == symbol && u.dimension == dimension; });
    if (unit != std::end(units)) return number * unit->factor / unit->divisor;
    const auto foreign =
        std::find_if(std::begin(units), std::end(units), [&](const Unit& u) { return u.symbol == symbol; });
    const std::string allowed = unit_list(dimension, is_length && particle_diameter);
    if (foreign != std::end(units)) {
        throw UnitError(fmt::format("\"{}\" is the unit of {}, but {} is wanted; use one of {}", symbol,
                                    dimension_name(foreign->dimension), dimension_name(dimension), allowed));
    }
    throw UnitError(fmt::format("\"{}\" is no unit of {}; use one of {}", symbol, dimension_name(dimension), allowed));
}

}  // namespace

std::string_view si_unit(Dimension dimension) {
    const auto unit =
        std::find_if(std::begin(units), std::end(units), [&](const Unit& u) { return u.dimension == dimension; });
    return unit == std::end(units) ? std::string_view{} : unit->symbol;
}

std::string_view dimension_name(Dimension dimension) {
    switch (dimension) {
        case Dimension::none:
            return "a plain number";
        case Dimension::length:
            return "a length";
        case Dimension::time:
            return "a time";
        case Dimension::speed:
            return "a speed";
        case Dimension::acceleration:
            return "an acceleration";
        case Dimension::density:
            return "a density";
        case Dimension::pressure:
            return "a pressure";
        case Dimension::energy:
            return "an energy";
        case Dimension::angle:
            return "an angle";
        case Dimension::angular_velocity:
            return "an angular velocity";
        case Dimension::force:
            return "a force";
    }
    return "a quantity";
}

double parse_quantity(std::string_view text, Dimension dimension, std::optional<double> particle_diameter,
                      bool plain_is_si) {
    text = trimmed(text);
    const std::size_t length = number_length(text);
    if (length == 0) {
        throw UnitError(fmt::format(
            "\"{}\" is not {}; write a number{}", text, dimension_name(dimension),
            dimension == Dimension::none ? "" : fmt::format(" with a unit, as in \"1 {}\"", si_unit(dimension))));
    }
    const double number = *parse_number(text.substr(0, length));
    if (!std::isfinite(number)) throw UnitError(fmt::format("\"{}\" is not a finite number", text));
    const std::string_view symbol = trimmed(text.substr(length));
    if (symbol.empty()) {
        if (dimension == Dimension::none || plain_is_si || number == 0) return number;
        throw UnitError(fmt::format("\"{}\" has no unit; {} is wanted: use one of {}", text, dimension_name(dimension),
                                    unit_list(dimension, dimension == Dimension::length && particle_diameter)));
    }
    if (dimension == Dimension::none) {
        throw UnitError(fmt::format("\"{}\" has a unit, but a plain number is wanted; leave out \"{}\"", text, symbol));
    }
    return in_si(number, symbol, dimension, particle_diameter);
}

}  // namespace recoat
