#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <tbb/global_control.h>

#include "analyzer/analysis.hpp"
#include "analyzer/output/hdf5_report.hpp"
#include "analyzer/output/json_report.hpp"
#include "analyzer/output/text_report.hpp"
#include "analyzer/readers/reader.hpp"
#include "common/error.hpp"
#include "common/output_file.hpp"
#include "common/version.hpp"

namespace {

using namespace recoat;

struct Arguments {
    std::string file, config, json, out;
    std::vector<std::string> settings;
    int threads = 0;
    bool as_json = false;
    bool quiet = false;
};

int metrics(const Arguments& arguments) {
    std::unique_ptr<tbb::global_control> limit;
    if (arguments.threads > 0) {
        limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism, arguments.threads);
    }
    const Config config = Config::load(arguments.config, arguments.settings);
    const Source source = read_particles(arguments.file, {.columns = read_column_names(config)});
    const AnalysisConfig resolved = read_analysis_config(config, source.info);
    const Analysis analysis = analyse(make_layer(source, resolved), resolved);
    if (!arguments.out.empty()) {
        write_hdf5_report(arguments.out, analysis, resolved, {arguments.file, source.format});
    }
    if (!arguments.json.empty()) write_text_file(arguments.json, json_report(analysis, resolved).dump() + "\n");
    if (!arguments.quiet) std::fputs(text_summary(analysis, resolved).c_str(), stdout);
    return 0;
}

int describe(const Arguments& arguments) {
    const Source source = read_particles(arguments.file);
    std::fputs(describe_source(source, arguments.file, arguments.as_json).c_str(), stdout);
    return 0;
}

int parse_and_run(int argc, char** argv) {
    CLI::App app("Measures spread powder layers: packing, surface, coordination, clusters.", "recoat-analyze");
    app.set_version_flag("--version", "recoat-analyze " + program_version());
    app.require_subcommand(1);
    Arguments arguments;

    CLI::App* measure = app.add_subcommand("metrics", "Measure a layer");
    measure->add_option("layer", arguments.file, "File of particles: a state of recoat-solve or a CSV table")
        ->required();
    measure->add_option("--config", arguments.config, "Configuration (YAML or JSON)")->required();
    measure->add_option("--json", arguments.json, "Results as JSON");
    measure->add_option("--out", arguments.out, "Results as HDF5");
    measure
        ->add_option("--set", arguments.settings, "Replace a value of the configuration: key=value (may be repeated)")
        ->allow_extra_args(false);
    measure->add_option("--threads", arguments.threads, "Number of threads; all cores if not given")
        ->check(CLI::PositiveNumber);
    measure->add_flag("--quiet", arguments.quiet, "No summary on the terminal");

    CLI::App* tell = app.add_subcommand("describe", "Say what a file of particles holds");
    tell->add_option("file", arguments.file, "File of particles")->required();
    tell->add_flag("--json", arguments.as_json, "As one JSON object");

    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp& error) {
        return app.exit(error);
    } catch (const CLI::CallForVersion& error) {
        return app.exit(error);
    } catch (const CLI::ParseError& error) {
        throw InputError(fmt::format("{}; see recoat-analyze --help", error.what()));
    }
    return measure->parsed() ? metrics(arguments) : describe(arguments);
}

}  // namespace

int main(int argc, char** argv) {
    return run_program("recoat-analyze", [&] { return parse_and_run(argc, argv); });
}
