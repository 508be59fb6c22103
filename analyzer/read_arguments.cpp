#include "analyzer/read_arguments.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "analyzer/configuration.hpp"
#include "common/config.hpp"
#include "common/error.hpp"
#include "common/number.hpp"
#include "common/units.hpp"

namespace recoat {
namespace {

double length(std::string_view option, std::string_view text) {
    try {
        return parse_quantity(trimmed(text), Dimension::length, {}, true);
    } catch (const UnitError& error) {
        throw InputError(fmt::format("{}: {}", option, error.what()));
    }
}

/// "LOWER,UPPER" in metres.
std::pair<double, double> bounds(std::string_view option, std::string_view text) {
    const std::size_t comma = text.find(',');
    if (comma == std::string_view::npos) {
        throw InputError(fmt::format("{}: \"{}\" is not two lengths; write LOWER,UPPER, e.g. 0,1mm", option, text));
    }
    const std::pair result(length(option, text.substr(0, comma)), length(option, text.substr(comma + 1)));
    if (result.first < result.second) return result;
    throw InputError(fmt::format("{}: \"{}\" ends before it begins; write LOWER,UPPER, e.g. 0,1mm", option, text));
}

StepChoice step_choice(const std::string& text) {
    if (text == "last") return {StepChoice::Which::last, 0};
    if (text == "first") return {StepChoice::Which::first, 0};
    if (const auto number = parse_integer(text)) return {StepChoice::Which::number, *number};
    if (all_steps(text))
        throw InputError("--step: all is for metrics, describe and convert; write last, first or a number here");
    throw InputError(fmt::format("--step: \"{}\" is no time step; write last, first or its number", text));
}

double radius(std::string_view text) {
    const double value = length("--radius", text);
    if (value > 0) return value;
    throw InputError(fmt::format("--radius: \"{}\" is not above zero; give a length", text));
}

/// "25um", or "TYPE=25um,TYPE=15um".
void read_radius(std::string_view text, ReadOptions& options) {
    if (text.find('=') == std::string_view::npos) {
        options.radius = radius(text);
        return;
    }
    while (!text.empty()) {
        const std::string_view part = text.substr(0, text.find(','));
        const std::size_t sign = part.find('=');
        if (sign == std::string_view::npos || sign == 0) {
            throw InputError(fmt::format(
                "--radius: \"{}\" is not TYPE=RADIUS; write e.g. 1=25um,2=15um, or one radius for all", part));
        }
        options.radius_of_type[std::string(trimmed(part.substr(0, sign)))] = radius(part.substr(sign + 1));
        text.remove_prefix(std::min(part.size() + 1, text.size()));
    }
}

}  // namespace

bool all_steps(std::string_view step) { return step == "all"; }

void add_read_arguments(CLI::App& command, ReadArguments& arguments) {
    command.add_option("--length-unit", arguments.length_unit, "Unit of length of a file that has none: m, mm, um, nm");
    command.add_option("--radius", arguments.radius,
                       "Radius of all particles of a file without, e.g. 25um, or of each type, e.g. 1=25um,2=15um");
    auto* radius = command.add_option("--radius-column", arguments.radius_column, "Column or array of the radius");
    command.add_option("--diameter-column", arguments.diameter_column, "Column or array of the diameter")
        ->excludes(radius);
    auto* kept = command.add_option("--type", arguments.types, "Keep the particles of these types only, e.g. 1,3");
    kept->delimiter(',')->allow_extra_args(false);
    command
        .add_option("--without-type", arguments.types_left_out, "Leave out the particles of these types, e.g. a plate")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->excludes(kept);
    command.add_option("--type-column", arguments.type_column, "Column or array of the type");
    command.add_option("--atom-style", arguments.atom_style,
                       "Atom style of a LAMMPS data file that does not say it, e.g. sphere");
    command.add_flag("--skip-size-zero", arguments.skip_size_zero, "Leave out particles of size 0");
    command.add_option("--step", arguments.step, "Time step of a file with several: last, first, its number, or all");
}

void add_column_settings(CLI::App& command, std::vector<std::string>& settings) {
    command
        .add_option("--set", settings,
                    "Name of a column: columns.x=NAME, and so y, z, radius, diameter, type (may be repeated)")
        ->allow_extra_args(false);
}

ColumnNames column_names(const std::vector<std::string>& settings) {
    const Config config = Config::parse("{}", "--set", settings);
    ColumnNames names = read_column_names(config);
    config.finish();
    return names;
}

void add_frame_arguments(CLI::App& command, FrameArguments& arguments) {
    command.add_option("--region", arguments.region, "Region along x, START,END, e.g. 2mm,4mm");
    command.add_option("--base", arguments.base, "Height z of the base");
    command.add_option("--period", arguments.period, "Period along y, y=LOWER,UPPER, e.g. y=0,1mm");
}

ReadOptions read_options(const ReadArguments& arguments, ColumnNames columns) {
    ReadOptions options;
    options.columns = std::move(columns);
    if (!arguments.radius_column.empty() || !arguments.diameter_column.empty()) {
        options.columns.radius = arguments.radius_column;
        options.columns.diameter = arguments.diameter_column;
    }
    if (!arguments.length_unit.empty()) {
        options.length_unit = length("--length-unit", "1 " + arguments.length_unit);
    }
    if (!arguments.type_column.empty()) options.columns.type = arguments.type_column;
    if (!arguments.radius.empty()) read_radius(arguments.radius, options);
    options.atom_style = arguments.atom_style;
    options.types = arguments.types;
    options.types_left_out = arguments.types_left_out;
    options.leave_out_size_zero = arguments.skip_size_zero;
    options.step = step_choice(arguments.step);
    return options;
}

std::vector<FrameSetting> frame_settings(const FrameArguments& arguments) {
    std::vector<FrameSetting> settings;
    if (!arguments.region.empty()) {
        const auto [begin, end] = bounds("--region", arguments.region);
        settings.push_back(
            {"x_range", fmt::format("[{}, {}]", shortest(begin), shortest(end)), "--region " + arguments.region});
    }
    if (!arguments.base.empty()) {
        settings.push_back({"base", shortest(length("--base", arguments.base)), "--base " + arguments.base});
    }
    if (!arguments.period.empty()) {
        if (!arguments.period.starts_with("y=")) {
            throw InputError(
                fmt::format("--period: \"{}\" does not begin with y=, the only direction that can be "
                            "periodic; write y=LOWER,UPPER",
                            arguments.period));
        }
        const auto [lower, upper] = bounds("--period", std::string_view(arguments.period).substr(2));
        const std::string option = "--period " + arguments.period;
        settings.push_back({"y_min", shortest(lower), option});
        settings.push_back({"y_period", shortest(upper - lower), option});
    }
    return settings;
}

}  // namespace recoat
