#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analyzer/readers/source.hpp"

namespace CLI {
class App;
}

namespace recoat {

/// Options of every command that reads particles, as texts.
struct ReadArguments {
    std::string length_unit, radius, radius_column, diameter_column, type_column, atom_style, step = "last";
    std::vector<std::string> types, types_left_out;
    bool skip_size_zero = false;
};

/// Options that say where a layer lies, as texts.
struct FrameArguments {
    std::string region, base, period;
};

void add_read_arguments(CLI::App& command, ReadArguments& arguments);
void add_frame_arguments(CLI::App& command, FrameArguments& arguments);

/// --set of commands that have no configuration, for names of columns only.
void add_column_settings(CLI::App& command, std::vector<std::string>& settings);
/// The names that these settings give. Throws InputError naming a setting of anything else.
[[nodiscard]] ColumnNames column_names(const std::vector<std::string>& settings);

/// Whether --step asks for every time step of the file, which a command has to see to itself.
[[nodiscard]] bool all_steps(std::string_view step);

/// What the options mean; `columns` are names that the configuration gives. Throws InputError naming the option.
[[nodiscard]] ReadOptions read_options(const ReadArguments& arguments, ColumnNames columns = {});

/// A value of the configuration that an option of its own gives.
struct FrameSetting {
    std::string key, value;
    std::string option;  ///< as it was written, e.g. "--region 2mm,4mm"
};

/// What the options set. Throws InputError naming the option.
[[nodiscard]] std::vector<FrameSetting> frame_settings(const FrameArguments& arguments);

}  // namespace recoat
