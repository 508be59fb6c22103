#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <tbb/global_control.h>

#include "analyzer/analysis.hpp"
#include "analyzer/output/hdf5_report.hpp"
#include "analyzer/output/json_report.hpp"
#include "analyzer/output/particle_file.hpp"
#include "analyzer/output/text_report.hpp"
#include "analyzer/read_arguments.hpp"
#include "analyzer/readers/frame.hpp"
#include "analyzer/readers/reader.hpp"
#include "common/error.hpp"
#include "common/output_file.hpp"
#include "common/version.hpp"

namespace {

using namespace recoat;

struct Arguments {
    std::string file, config, json, out, format;
    std::vector<std::string> settings;
    ReadArguments read;
    FrameArguments frame;
    int threads = 0;
    bool as_json = false;
    bool quiet = false;
};

Config load_config(const Arguments& arguments) {
    std::vector<std::string> settings = arguments.settings;
    for (const std::string& setting : frame_settings(arguments.frame)) settings.push_back(setting);
    if (arguments.config.empty()) return Config::parse("{}", "--config (not given)", settings);
    return Config::load(arguments.config, settings);
}

int metrics(const Arguments& arguments) {
    std::unique_ptr<tbb::global_control> limit;
    if (arguments.threads > 0) {
        limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism, arguments.threads);
    }
    const Config config = load_config(arguments);
    Source source = read_particles(arguments.file, read_options(arguments.read, read_column_names(config)));
    complete_frame(source);
    const AnalysisConfig resolved = read_analysis_config(config, source.info);
    lower_to_base(source, resolved.base);
    const Analysis analysis = analyse(make_layer(source, resolved), resolved);
    if (!arguments.out.empty()) {
        write_hdf5_report(arguments.out, analysis, resolved, {arguments.file, source.format});
    }
    if (!arguments.json.empty()) write_text_file(arguments.json, json_report(analysis, resolved).dump() + "\n");
    if (!arguments.quiet) std::fputs(text_summary(analysis, resolved).c_str(), stdout);
    return 0;
}

int describe(const Arguments& arguments) {
    if (arguments.file.empty()) {
        for (const Reader& reader : readers()) fmt::print("{:14} {}\n", reader.name, reader.description);
        return 0;
    }
    const Source source = read_particles(arguments.file, read_options(arguments.read));
    std::fputs(describe_source(source, arguments.file, arguments.as_json).c_str(), stdout);
    return 0;
}

int convert(const Arguments& arguments) {
    const Source source = read_particles(arguments.file, read_options(arguments.read));
    write_particle_file(arguments.out, arguments.format, source);
    return 0;
}

int parse_and_run(int argc, char** argv) {
    CLI::App app("Measures spread powder layers: packing, surface, coordination, clusters.", "recoat-analyze");
    app.set_version_flag("--version", "recoat-analyze " + program_version());
    app.require_subcommand(1);
    Arguments arguments;

    CLI::App* measure = app.add_subcommand("metrics", "Measure a layer");
    measure->add_option("layer", arguments.file, "File of particles; \"describe\" without a file lists the formats")
        ->required();
    measure->add_option("--config", arguments.config, "Configuration (YAML or JSON)");
    add_read_arguments(*measure, arguments.read);
    add_frame_arguments(*measure, arguments.frame);
    measure->add_option("--json", arguments.json, "Results as JSON");
    measure->add_option("--out", arguments.out, "Results as HDF5");
    measure
        ->add_option("--set", arguments.settings, "Replace a value of the configuration: key=value (may be repeated)")
        ->allow_extra_args(false);
    measure->add_option("--threads", arguments.threads, "Number of threads; all cores if not given")
        ->check(CLI::PositiveNumber);
    measure->add_flag("--quiet", arguments.quiet, "No summary on the terminal");

    CLI::App* tell = app.add_subcommand("describe", "Say what a file of particles holds");
    tell->add_option("file", arguments.file, "File of particles; without it, the formats are listed");
    tell->add_flag("--json", arguments.as_json, "As one JSON object");
    add_read_arguments(*tell, arguments.read);

    CLI::App* rewrite = app.add_subcommand("convert", "Write particles in another format, in metres");
    rewrite->add_option("file", arguments.file, "File of particles")->required();
    rewrite->add_option("out", arguments.out, "New file: .csv, .vtp, .dump or .vtkhdf")->required();
    rewrite->add_option("--format", arguments.format, "csv, vtp, lammps-dump or vtkhdf, whatever the ending");
    add_read_arguments(*rewrite, arguments.read);

    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp& error) {
        return app.exit(error);
    } catch (const CLI::CallForVersion& error) {
        return app.exit(error);
    } catch (const CLI::ParseError& error) {
        throw InputError(fmt::format("{}; see recoat-analyze --help", error.what()));
    }
    if (measure->parsed()) return metrics(arguments);
    return tell->parsed() ? describe(arguments) : convert(arguments);
}

}  // namespace

int main(int argc, char** argv) {
    return run_program("recoat-analyze", [&] { return parse_and_run(argc, argv); });
}
