#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "analyzer/commands/commands.hpp"
#include "analyzer/output/description.hpp"
#include "analyzer/read_arguments.hpp"
#include "analyzer/readers/reader.hpp"

namespace recoat {
namespace {

struct Arguments {
    std::string file;
    ReadArguments read;
    bool as_json = false;
};

void describe(const Arguments& arguments) {
    if (arguments.file.empty()) {
        for (const Reader& reader : readers()) fmt::print("{:14} {}\n", reader.name, reader.description);
        return;
    }
    const Source source = read_particles(arguments.file, read_options(arguments.read));
    std::fputs(describe_source(source, arguments.file, arguments.as_json).c_str(), stdout);
}

}  // namespace

void add_describe_command(CLI::App& app) {
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* command = app.add_subcommand("describe", "Say what a file of particles holds");
    command->add_option("file", arguments->file, "File of particles; without it, the formats are listed");
    command->add_flag("--json", arguments->as_json, "As one JSON object");
    add_read_arguments(*command, arguments->read);
    command->callback([arguments] { describe(*arguments); });
}

}  // namespace recoat
