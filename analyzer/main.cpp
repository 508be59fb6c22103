#include "analyzer/commands/commands.hpp"
#include "analyzer/freed_memory.hpp"
#include "common/command_line.hpp"
#include "common/error.hpp"
#include "common/version.hpp"

namespace {

int parse_and_run(int argc, char** argv) {
    CLI::App app("Measures spread powder layers: packing, surface, coordination, clusters, pores.", "recoat-analyze");
    app.set_version_flag("--version", "recoat-analyze " + recoat::program_version());
    app.require_subcommand(1);
    recoat::add_metrics_command(app);
    recoat::add_convergence_command(app);
    recoat::add_describe_command(app);
    recoat::add_convert_command(app);
    return recoat::parse_command_line(app, argc, argv).value_or(0);
}

}  // namespace

int main(int argc, char** argv) {
    recoat::keep_freed_memory();
    return recoat::run_program("recoat-analyze", [&] { return parse_and_run(argc, argv); });
}
