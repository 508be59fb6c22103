#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "analyzer/commands/commands.hpp"
#include "analyzer/commands/warnings.hpp"
#include "analyzer/output/particle_file.hpp"
#include "analyzer/read_arguments.hpp"
#include "analyzer/readers/reader.hpp"
#include "common/error.hpp"

namespace recoat {
namespace {

struct Arguments {
    std::string file, out, format;
    ReadArguments read;
    std::vector<std::string> settings;
};

/// Adds a time step, with warnings of what its file and the new one do not hold. The file begins with the first step.
void add_step(std::unique_ptr<ParticleWriter>& writer, const Arguments& arguments, const ParticleFormat& format,
              Source source, Warnings& warnings) {
    const std::string lost = not_kept(format, source);
    if (!lost.empty()) {
        source.warnings.push_back(
            fmt::format("{}: the format {} has no place for {}; left out", arguments.out, format.name, lost));
    }
    warnings.show(source);
    if (!writer) writer = format.open(arguments.out);
    writer->add(source);
}

void convert(const Arguments& arguments) {
    const ParticleFormat& format = particle_format(arguments.out, arguments.format);
    ReadArguments read = arguments.read;
    const bool all = all_steps(read.step);
    if (all) read.step = "last";
    const ReadOptions options = read_options(read, column_names(arguments.settings));
    const Recording recording(arguments.file, options);
    if (all && !format.several_steps) {
        throw InputError(fmt::format(
            "{}: a file of the format {} holds one time step; choose it with --step NUMBER, or write .dump, "
            ".vtkhdf or .xyz",
            arguments.out, format.name));
    }
    Warnings warnings;
    if (all) recording.require_whole();
    std::unique_ptr<ParticleWriter> writer;
    if (!all) add_step(writer, arguments, format, recording.read(options.step), warnings);
    for (std::size_t index = 0; all && index < recording.steps().size(); ++index) {
        add_step(writer, arguments, format, recording.read(index), warnings);
    }
    writer->finish();
}

}  // namespace

void add_convert_command(CLI::App& app) {
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* command = app.add_subcommand("convert", "Write particles in another format, in metres");
    command->add_option("file", arguments->file, "File of particles")->required();
    command->add_option("out", arguments->out, "New file: .csv, .vtp, .dump, .vtkhdf or .xyz")->required();
    command->add_option("--format", arguments->format,
                        "csv, vtp, lammps-dump, vtkhdf or extended-xyz, whatever the ending");
    add_read_arguments(*command, arguments->read);
    add_column_settings(*command, arguments->settings);
    command->callback([arguments] { convert(*arguments); });
}

}  // namespace recoat
