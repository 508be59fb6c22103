#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "analyzer/configuration.hpp"
#include "analyzer/fields/layer.hpp"
#include "analyzer/read_arguments.hpp"
#include "common/config.hpp"

namespace recoat {

/// Options of every command that measures a layer, as texts.
struct LayerArguments {
    std::string file, config;
    std::vector<std::string> settings;
    ReadArguments read;
    FrameArguments frame;
    int threads = 0;
};
void add_layer_arguments(CLI::App& command, LayerArguments& arguments);

/// The configuration file with what --set and the options of the frame say. Throws InputError.
[[nodiscard]] Config load_config(const LayerArguments& arguments);

/// A layer with what it is measured by.
struct PreparedLayer {
    Layer layer;
    AnalysisConfig config;
    Source source;  ///< z from the base
};
/// Reads the layer; what neither file nor configuration says comes from the particles. Throws InputError.
[[nodiscard]] PreparedLayer prepare_layer(const LayerArguments& arguments);

/// Measures every time step of the file: `take` gets each, in the order of the file. Where the layer lies is found
/// once, from the last step. Throws InputError.
void for_each_step(const LayerArguments& arguments,
                   const std::function<void(std::int64_t step, PreparedLayer prepared)>& take);

/// Calls `body` with at most as many threads as the option allows.
void with_threads(const LayerArguments& arguments, const std::function<void()>& body);

}  // namespace recoat
