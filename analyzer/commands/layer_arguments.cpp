#include "analyzer/commands/layer_arguments.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <tbb/global_control.h>

#include "analyzer/commands/warnings.hpp"
#include "analyzer/readers/frame.hpp"
#include "analyzer/readers/reader.hpp"
#include "analyzer/region.hpp"
#include "common/command_line.hpp"
#include "common/error.hpp"

namespace recoat {

void add_layer_arguments(CLI::App& command, LayerArguments& arguments) {
    command.add_option("layer", arguments.file, "File of particles; \"describe\" without a file lists the formats")
        ->required();
    command.add_option("--config", arguments.config, "Configuration (YAML or JSON)");
    add_read_arguments(command, arguments.read);
    add_frame_arguments(command, arguments.frame);
    command
        .add_option("--set", arguments.settings, "Replace a value of the configuration: key=value (may be repeated)")
        ->allow_extra_args(false);
    command.add_option("--threads", arguments.threads, "Number of threads; all cores if not given")
        ->check(whole_number(1, 1024));
}

Config load_config(const LayerArguments& arguments) {
    std::vector<std::string> settings = arguments.settings;
    const std::vector<FrameSetting> frame = frame_settings(arguments.frame);
    for (const FrameSetting& setting : frame) settings.push_back(setting.key + "=" + setting.value);
    Config config =
        arguments.config.empty() ? Config::parse("{}", "", settings) : Config::load(arguments.config, settings);
    for (const FrameSetting& setting : frame) config.set_option(setting.key, setting.option);
    return config;
}

namespace {

/// Without particles there is nothing to measure, unless the configuration says all that they would show.
bool is_empty(const Source& source, const Config& config) { return source.position.empty() && !config.has("d_p"); }

std::string no_particles(const LayerArguments& arguments, const Recording& recording, const Source& source) {
    if (recording.steps().size() == 1) return fmt::format("{}: the file has no particles", arguments.file);
    return fmt::format("{}: the time step {} has no particles", arguments.file, source.step);
}

/// @throws InputError when a file has particles, but none of them lies in the region, or the region reaches far beyond.
void check_region(const Config& config, const PreparedLayer& prepared, const LayerArguments& arguments) {
    const AnalysisConfig& resolved = prepared.config;
    check_reach(config, prepared.source.info, {resolved.x_begin, resolved.x_end},
                resolved.phi_window * resolved.particle_diameter);
    const std::vector<char>& in_region = prepared.layer.in_region;
    const std::vector<Vec3>& position = prepared.source.position;
    if (position.empty() || std::ranges::find(in_region, 1) != in_region.end()) return;
    const auto [low, high] = std::ranges::minmax(position, {}, &Vec3::x);
    throw InputError(
        fmt::format("{}: no particle has its centre in the region x = {:.9g} ... {:.9g} m; they lie between "
                    "x = {:.9g} and {:.9g} m: give a region there (--region, x_range)",
                    arguments.file, resolved.x_begin, resolved.x_end, low.x, high.x));
}

PreparedLayer prepared_from(Source source, const AnalysisConfig& config) {
    lower_to_base(source, config.base);
    Layer layer = make_layer(source, config);
    return {std::move(layer), config, std::move(source)};
}

/// The configuration with the frame of the last time step that has particles.
AnalysisConfig config_of_last(const LayerArguments& arguments, const Recording& recording, const Config& config) {
    for (std::size_t index = recording.steps().size(); index > 0; --index) {
        Source source = recording.read(index - 1);
        if (is_empty(source, config)) continue;
        wrap_along_x(source);
        complete_frame(source);
        AnalysisConfig resolved = read_analysis_config(config, source.info);
        check_region(config, prepared_from(std::move(source), resolved), arguments);
        return resolved;
    }
    throw InputError(fmt::format("{}: no time step has particles; give a file that has", arguments.file));
}

}  // namespace

PreparedLayer prepare_layer(const LayerArguments& arguments) {
    const Config config = load_config(arguments);
    const ReadOptions options = read_options(arguments.read, read_column_names(config));
    const Recording recording(arguments.file, options);
    Source source = recording.read(options.step);
    Warnings().show(source);
    if (is_empty(source, config)) {
        throw InputError(no_particles(arguments, recording, source) +
                         (recording.steps().size() == 1 ? "; give one that has" : "; choose another with --step"));
    }
    wrap_along_x(source);
    complete_frame(source);
    const AnalysisConfig resolved = read_analysis_config(config, source.info);
    PreparedLayer prepared = prepared_from(std::move(source), resolved);
    check_region(config, prepared, arguments);
    return prepared;
}

void for_each_step(const LayerArguments& arguments,
                   const std::function<void(std::int64_t step, PreparedLayer prepared)>& take) {
    const Config config = load_config(arguments);
    ReadArguments read = arguments.read;
    read.step = "last";
    const Recording recording(arguments.file, read_options(read, read_column_names(config)));
    recording.require_whole();
    const AnalysisConfig resolved = config_of_last(arguments, recording, config);
    Warnings warnings;
    for (std::size_t index = 0; index < recording.steps().size(); ++index) {
        Source source = recording.read(index);
        const bool empty = is_empty(source, config);
        if (empty) source.warnings.push_back(no_particles(arguments, recording, source) + "; it is passed over");
        warnings.show(source);
        if (empty) continue;
        wrap_along_x(source);
        take(recording.steps()[index], prepared_from(std::move(source), resolved));
    }
}

void with_threads(const LayerArguments& arguments, const std::function<void()>& body) {
    if (arguments.threads == 0) return body();
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, arguments.threads);
    body();
}

}  // namespace recoat
