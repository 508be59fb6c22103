#include "analyzer/read_arguments.hpp"

#include <optional>
#include <string_view>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

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
        throw InputError("--step: all is for metrics and describe; write last, first or a number here");
    throw InputError(fmt::format("--step: \"{}\" is no time step; write last, first or its number", text));
}

}  // namespace

bool all_steps(std::string_view step) { return step == "all"; }

void add_read_arguments(CLI::App& command, ReadArguments& arguments) {
    command.add_option("--length-unit", arguments.length_unit, "Unit of length of a file that has none: m, mm, um, nm");
    command.add_option("--radius", arguments.radius, "Radius of all particles of a file without, e.g. 25um");
    auto* radius = command.add_option("--radius-column", arguments.radius_column, "Column or array of the radius");
    command.add_option("--diameter-column", arguments.diameter_column, "Column or array of the diameter")
        ->excludes(radius);
    command.add_option("--step", arguments.step,
                       "Time step of a file with several: last, first, its number, or (metrics, describe) all");
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
    if (!arguments.radius.empty()) {
        options.radius = length("--radius", arguments.radius);
        if (!(*options.radius > 0)) {
            throw InputError(fmt::format("--radius: \"{}\" is not above zero; give a length", arguments.radius));
        }
    }
    options.step = step_choice(arguments.step);
    return options;
}

std::vector<std::string> frame_settings(const FrameArguments& arguments) {
    std::vector<std::string> settings;
    if (!arguments.region.empty()) {
        const auto [begin, end] = bounds("--region", arguments.region);
        settings.push_back(fmt::format("x_range=[{}, {}]", shortest(begin), shortest(end)));
    }
    if (!arguments.base.empty()) settings.push_back("base=" + shortest(length("--base", arguments.base)));
    if (!arguments.period.empty()) {
        if (!arguments.period.starts_with("y=")) {
            throw InputError(
                fmt::format("--period: \"{}\" does not begin with y=, the only direction that can be "
                            "periodic; write y=LOWER,UPPER",
                            arguments.period));
        }
        const auto [lower, upper] = bounds("--period", std::string_view(arguments.period).substr(2));
        settings.push_back("y_min=" + shortest(lower));
        settings.push_back("y_period=" + shortest(upper - lower));
    }
    return settings;
}

}  // namespace recoat
