#include "analyzer/convergence.hpp"

#include <algorithm>
#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analyzer/commands/commands.hpp"
#include "analyzer/commands/layer_arguments.hpp"
#include "analyzer/output/convergence_report.hpp"
#include "common/output_file.hpp"

namespace recoat {
namespace {

struct Arguments {
    LayerArguments layer;
    std::vector<int> voxels = {4, 5, 8, 10, 20, 40};
    double tolerance = 0.01;
    std::string json;
};

void study(const Arguments& arguments) {
    std::vector<int> voxels = arguments.voxels;
    std::ranges::sort(voxels);
    voxels.erase(std::unique(voxels.begin(), voxels.end()), voxels.end());
    LayerArguments layer = arguments.layer;
    layer.settings.push_back(fmt::format("voxels_per_dp=[{}]", fmt::join(voxels, ", ")));
    PreparedLayer prepared = prepare_layer(layer);
    const Convergence result = convergence(analyse(std::move(prepared.layer), prepared.config), arguments.tolerance);
    if (!arguments.json.empty()) write_text_file(arguments.json, convergence_json(result).dump(1) + "\n");
    std::fputs(convergence_text(result).c_str(), stdout);
}

}  // namespace

void add_convergence_command(CLI::App& app) {
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* command =
        app.add_subcommand("convergence", "Say how many voxels per d_p the voxel forms need on a layer");
    add_layer_arguments(*command, arguments->layer);
    command->add_option("--voxels", arguments->voxels, "Voxels per d_p, e.g. 5,10,20; 4,5,8,10,20,40 if not given")
        ->delimiter(',')
        ->check(CLI::Range(1, 1000));
    command
        ->add_option("--tolerance", arguments->tolerance,
                     "Allowed error as a share of the exact value; 0.01 if not given")
        ->check(CLI::Range(1e-12, 1.0));
    command->add_option("--json", arguments->json, "The table as JSON");
    command->callback([arguments] { with_threads(arguments->layer, [&] { study(*arguments); }); });
}

}  // namespace recoat
