#include <memory>

#include <CLI/CLI.hpp>

#include "analyzer/commands/commands.hpp"
#include "analyzer/commands/warnings.hpp"
#include "analyzer/output/particle_file.hpp"
#include "analyzer/read_arguments.hpp"
#include "analyzer/readers/reader.hpp"

namespace recoat {
namespace {

struct Arguments {
    std::string file, out, format;
    ReadArguments read;
};

}  // namespace

void add_convert_command(CLI::App& app) {
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* command = app.add_subcommand("convert", "Write particles in another format, in metres");
    command->add_option("file", arguments->file, "File of particles")->required();
    command->add_option("out", arguments->out, "New file: .csv, .vtp, .dump or .vtkhdf")->required();
    command->add_option("--format", arguments->format, "csv, vtp, lammps-dump or vtkhdf, whatever the ending");
    add_read_arguments(*command, arguments->read);
    command->callback([arguments] {
        const Source source = read_particles(arguments->file, read_options(arguments->read));
        Warnings().show(source);
        write_particle_file(arguments->out, arguments->format, source);
    });
}

}  // namespace recoat
