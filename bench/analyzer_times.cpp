#include <algorithm>
#include <chrono>
#include <ctime>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>
#include <tbb/global_control.h>

#include "analyzer/analysis.hpp"
#include "analyzer/fields/height_map.hpp"
#include "analyzer/fields/spatial_order.hpp"
#include "analyzer/freed_memory.hpp"
#include "analyzer/readers/reader.hpp"
#include "common/error.hpp"

namespace {

using namespace recoat;

double wall_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Times parts of the work several times each.
class Clock {
public:
    explicit Clock(int repeats) : repeats_(repeats) {}

    template <class Work>
    auto time(const std::string& name, Work work) {
        std::vector<double> wall, cpu;
        auto result = work();
        for (int k = 0; k < repeats_; ++k) {
            const double wall_start = wall_seconds(), cpu_start = cpu_seconds();
            result = work();
            wall.push_back(wall_seconds() - wall_start);
            cpu.push_back(cpu_seconds() - cpu_start);
        }
        std::ranges::sort(wall);
        std::ranges::sort(cpu);
        parts_[name] = {{"wall_min", wall.front()}, {"wall_median", wall[wall.size() / 2]}, {"cpu_min", cpu.front()}};
        return result;
    }
    [[nodiscard]] const nlohmann::ordered_json& parts() const { return parts_; }

private:
    int repeats_;
    nlohmann::ordered_json parts_;
};

/// The parts of analyse(), one by one.
void time_exact(Clock& clock, const Layer& unsorted, const AnalysisConfig& config) {
    const SpatialOrder order = clock.time("order", [&] { return SpatialOrder(unsorted); });
    const Layer layer = clock.time("sort", [&] { return order.apply(unsorted); });
    const ContactGraph graph = clock.time("contacts", [&] { return find_contacts(layer, config); });
    const Clusters clusters = clock.time("clusters", [&] { return find_clusters(layer, graph); });
    clock.time("order of the file", [&] {
        static_cast<void>(order.coordination_numbers(graph));
        return order.restore(clusters);
    });
    clock.time("statistics", [&] {
        static_cast<void>(cluster_size_metrics(layer, clusters));
        static_cast<void>(orientation_metrics(layer, clusters, config.angle_bin, config.bin_tol));
        static_cast<void>(vertical_metrics(layer, config.z_bin, config.bin_tol));
        return coordination_metrics(layer, graph);
    });
    clock.time("totals", [&] { return totals_metrics(layer, config); });
    const PackingMaps packing = clock.time("packing density", [&] { return packing_maps(layer, config); });
    clock.time("surface height", [&] { return height_map(layer, config); });
    clock.time("density pores", [&] {
        static_cast<void>(density_pore_metrics(packing.exact, layer.grid, config, GridConnectivity::sides));
        return density_pore_metrics(packing.exact, layer.grid, config, GridConnectivity::sides_and_corners);
    });
    clock.time("chamber pores", [&] { return chamber_pore_metrics(layer, config); });
}

void time_all(Clock& clock, const Layer& unsorted, AnalysisConfig config) {
    const Layer layer = SpatialOrder(unsorted).apply(unsorted);
    for (const int n : config.voxels_per_dp) {
        clock.time(fmt::format("voxel maps {}", n), [&] { return voxel_maps(layer, config, n); });
        clock.time(fmt::format("pixel chambers {}", n), [&] { return pixel_chambers(layer, config, n); });
    }
    config.voxels_per_dp.clear();
    clock.time("all exact", [&] { return analyse(unsorted, config); });
}

int run(int argc, char** argv) {
    std::string file, configuration;
    std::vector<std::string> settings;
    int threads = 0, repeats = 5;
    bool exact_only = false;
    CLI::App app("Times of the parts of an analysis");
    app.add_option("layer", file, "File of particles")->required();
    app.add_option("--config", configuration, "Configuration")->required();
    app.add_option("--set", settings, "key=value")->allow_extra_args(false);
    app.add_option("--threads", threads, "threads; all cores if not given");
    app.add_option("--repeats", repeats, "timed runs of every part, after one that is not")->check(CLI::Range(1, 1000));
    app.add_flag("--total-only", exact_only, "only all exact metrics together");
    CLI11_PARSE(app, argc, argv);
    std::unique_ptr<tbb::global_control> limit;
    if (threads > 0)
        limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism, threads);
    const Source source = read_particles(file);
    const AnalysisConfig config = read_analysis_config(Config::load(configuration, settings), source.info);
    Clock clock(repeats);
    const Layer layer = clock.time("layer", [&] { return make_layer(source, config); });
    if (!exact_only) time_exact(clock, layer, config);
    time_all(clock, layer, config);
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const nlohmann::ordered_json result = {{"particles", layer.size()},
                                           {"threads", threads},
                                           {"peak_memory_MiB", usage.ru_maxrss / 1024},
                                           {"seconds", clock.parts()}};
    fmt::print("{}\n", result.dump(1));
    return 0;
}

}  // namespace

/// Times of the parts of an analysis, without start-up and reading, as one JSON object.
int main(int argc, char** argv) {
    keep_freed_memory();
    return run_program("analyzer-times", [&] { return run(argc, argv); });
}
