#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "analyzer/commands/commands.hpp"
#include "analyzer/commands/layer_arguments.hpp"
#include "analyzer/output/csv_tables.hpp"
#include "analyzer/output/hdf5_report.hpp"
#include "analyzer/output/json_report.hpp"
#include "analyzer/output/map_vti.hpp"
#include "analyzer/output/particle_vtp.hpp"
#include "analyzer/output/plots.hpp"
#include "analyzer/output/pore_vtp.hpp"
#include "analyzer/output/step_series.hpp"
#include "analyzer/output/summary.hpp"
#include "analyzer/output/voxel_volume.hpp"
#include "common/error.hpp"
#include "common/output_file.hpp"

namespace recoat {
namespace {

struct Arguments {
    LayerArguments layer;
    std::string json, out, csv, vtk, vdb, plots;
    int vdb_voxels = 10;
    bool quiet = false;
};

/// Particles, pores and maps for ParaView.
void write_vtk_files(const std::filesystem::path& folder, const Analysis& analysis, const AnalysisConfig& config,
                     const Source& source) {
    write_layer_vtp(folder / "particles.vtp", analysis, config, source);
    write_maps_vti(folder / "maps.vti", analysis, config);
    for (const DensityPoreMetrics& metrics : analysis.density_pores) {
        const int neighbours = static_cast<int>(metrics.connectivity);
        write_density_pores_vtp(folder / fmt::format("density_pores_{}.vtp", neighbours), analysis, config, metrics);
    }
    const ChamberPoreMetrics& chambers = analysis.chamber_pores;
    write_chambers_vtp(folder / "chamber_pores_L.vtp", chambers.all, config);
    write_chambers_vtp(folder / "chamber_pores_A.vtp", chambers.separate, config);
    write_chambers_vtp(folder / "chamber_pores_B.vtp", chambers.disjoint, config);
    if (chambers.persistent) write_chambers_vtp(folder / "chamber_pores_P.vtp", *chambers.persistent, config);
}

void metrics(const Arguments& arguments) {
    PreparedLayer prepared = prepare_layer(arguments.layer);
    const AnalysisConfig& config = prepared.config;
    // First: it may refuse its number of voxels.
    if (!arguments.vdb.empty()) write_voxel_volume(arguments.vdb, prepared.layer, config, arguments.vdb_voxels);
    const Analysis analysis = analyse(std::move(prepared.layer), config);
    const Uncertainty estimates = bootstrap(analysis, config);
    std::optional<Uncertainty> uncertainty;
    if (config.bootstrap_resamples > 0) uncertainty = estimates;
    if (!arguments.out.empty()) {
        write_hdf5_report(arguments.out, analysis, config, {arguments.layer.file, prepared.source.format}, uncertainty);
    }
    if (!arguments.json.empty())
        write_text_file(arguments.json, json_report(analysis, config, uncertainty).dump() + "\n");
    if (!arguments.csv.empty()) write_csv_tables(arguments.csv, analysis, config, estimates);
    if (!arguments.vtk.empty()) write_vtk_files(arguments.vtk, analysis, config, prepared.source);
    if (!arguments.plots.empty()) {
        AnalysisConfig drawn = config;
        if (!uncertainty) drawn.bootstrap_resamples = AnalysisConfig().bootstrap_resamples;  // figures have error bars
        const Uncertainty bars = uncertainty ? estimates : bootstrap(analysis, drawn);
        draw_plots(arguments.plots, json_report(analysis, config, bars).dump(), prepared.source);
    }
    if (!arguments.quiet) std::fputs(text_summary(analysis, config, uncertainty).c_str(), stdout);
}

void metrics_of_all_steps(const Arguments& arguments) {
    for (const auto& [option, value] : {std::pair("--vtk", &arguments.vtk), std::pair("--vdb", &arguments.vdb),
                                        std::pair("--plots", &arguments.plots)}) {
        if (!value->empty())
            throw InputError(fmt::format("{}: writes one time step; choose it with --step NUMBER", option));
    }
    std::optional<StepSeries> series;
    const auto take = [&](std::int64_t step, PreparedLayer prepared) {
        if (!series) {
            series.emplace(arguments.json, arguments.out, arguments.csv,
                           Provenance{arguments.layer.file, prepared.source.format});
            if (!arguments.quiet) std::fputs(StepSeries::text_head().c_str(), stdout);
        }
        const Analysis analysis = analyse(std::move(prepared.layer), prepared.config);
        const Uncertainty estimates = bootstrap(analysis, prepared.config);
        series->add(step, analysis, prepared.config, estimates);
        if (!arguments.quiet) std::fputs(StepSeries::text_line(step, analysis, estimates).c_str(), stdout);
    };
    for_each_step(arguments.layer, take);
    series->finish();
}

}  // namespace

void add_metrics_command(CLI::App& app) {
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* command = app.add_subcommand("metrics", "Measure a layer");
    add_layer_arguments(*command, arguments->layer);
    command->add_option("--json", arguments->json, "Results as JSON");
    command->add_option("--out", arguments->out, "Results as HDF5");
    command->add_option("--csv", arguments->csv, "Results as CSV tables in this folder");
    command->add_option("--vtk", arguments->vtk, "Particles, pores and maps as VTP and VTI in this folder");
    command->add_option("--vdb", arguments->vdb, "Solid and signed distance as OpenVDB");
    command->add_option("--vdb-voxels", arguments->vdb_voxels, "Voxels per d_p of --vdb; 10 if not given")
        ->check(CLI::Range(1, 1000));
    command->add_option("--plots", arguments->plots, "Standard figures in this folder, drawn with Python");
    command->add_flag("--quiet", arguments->quiet, "No summary on the terminal");
    command->callback([arguments] {
        with_threads(arguments->layer, [&] {
            if (all_steps(arguments->layer.read.step)) return metrics_of_all_steps(*arguments);
            metrics(*arguments);
        });
    });
}

}  // namespace recoat
