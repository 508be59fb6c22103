#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "analyzer/commands/commands.hpp"
#include "analyzer/commands/warnings.hpp"
#include "analyzer/output/description.hpp"
#include "analyzer/read_arguments.hpp"
#include "analyzer/readers/reader.hpp"

namespace recoat {
namespace {

struct Arguments {
    std::string file;
    ReadArguments read;
    std::vector<std::string> settings;
    bool as_json = false;
};

/// Every time step: blocks, or one list.
void describe_all(const Arguments& arguments) {
    ReadArguments read = arguments.read;
    read.step = "last";
    const Recording recording(arguments.file, read_options(read, column_names(arguments.settings)));
    recording.require_whole();
    std::string text;
    Warnings warnings;
    for (std::size_t index = 0; index < recording.steps().size(); ++index) {
        const Source source = recording.read(index);
        warnings.show(source);
        const std::string separator = text.empty() ? "" : arguments.as_json ? "," : "\n";
        text += fmt::format("{}{}", separator, describe_source(source, arguments.file, arguments.as_json));
    }
    std::fputs((arguments.as_json ? "[" + text + "]\n" : text).c_str(), stdout);
}

void describe(const Arguments& arguments) {
    if (arguments.file.empty()) {
        for (const Reader& reader : readers()) fmt::print("{:14} {}\n", reader.name, reader.description);
        return;
    }
    if (all_steps(arguments.read.step)) return describe_all(arguments);
    const Source source =
        read_particles(arguments.file, read_options(arguments.read, column_names(arguments.settings)));
    Warnings().show(source);
    std::fputs(describe_source(source, arguments.file, arguments.as_json).c_str(), stdout);
}

}  // namespace

void add_describe_command(CLI::App& app) {
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* command = app.add_subcommand("describe", "Say what a file of particles holds");
    command->add_option("file", arguments->file, "File of particles; without it, the formats are listed");
    command->add_flag("--json", arguments->as_json, "As one JSON object");
    add_read_arguments(*command, arguments->read);
    add_column_settings(*command, arguments->settings);
    command->callback([arguments] { describe(*arguments); });
}

}  // namespace recoat
