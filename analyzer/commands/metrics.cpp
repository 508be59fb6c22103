#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>

#include "analyzer/commands/commands.hpp"
#include "analyzer/commands/layer_arguments.hpp"
#include "analyzer/output/hdf5_report.hpp"
#include "analyzer/output/json_report.hpp"
#include "analyzer/output/summary.hpp"
#include "common/output_file.hpp"

namespace recoat {
namespace {

struct Arguments {
    LayerArguments layer;
    std::string json, out;
    bool quiet = false;
};

void metrics(const Arguments& arguments) {
    PreparedLayer prepared = prepare_layer(arguments.layer);
    const AnalysisConfig& config = prepared.config;
    const Analysis analysis = analyse(std::move(prepared.layer), config);
    std::optional<Uncertainty> uncertainty;
    if (config.bootstrap_resamples > 0) uncertainty = bootstrap(analysis, config);
    if (!arguments.out.empty()) {
        write_hdf5_report(arguments.out, analysis, config, {arguments.layer.file, prepared.format}, uncertainty);
    }
    if (!arguments.json.empty())
        write_text_file(arguments.json, json_report(analysis, config, uncertainty).dump() + "\n");
    if (!arguments.quiet) std::fputs(text_summary(analysis, config, uncertainty).c_str(), stdout);
}

}  // namespace

void add_metrics_command(CLI::App& app) {
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* command = app.add_subcommand("metrics", "Measure a layer");
    add_layer_arguments(*command, arguments->layer);
    command->add_option("--json", arguments->json, "Results as JSON");
    command->add_option("--out", arguments->out, "Results as HDF5");
    command->add_flag("--quiet", arguments->quiet, "No summary on the terminal");
    command->callback([arguments] { with_threads(arguments->layer, [&] { metrics(*arguments); }); });
}

}  // namespace recoat
