#pragma once

#include <filesystem>
#include <string>

#include "solver/engine/engine.hpp"
#include "solver/output/progress.hpp"

namespace recoat {

/// A run stopped between two steps.
struct Checkpoint {
    std::string version;  ///< of the program that wrote it
    std::string config;   ///< resolved configuration, YAML
    RunProgress progress;
    EngineState engine;
};

/// Writes the checkpoint whole or not at all. Throws InputError when the file cannot be written.
void write_checkpoint(const std::filesystem::path& file, const Checkpoint& checkpoint);

/// Throws InputError when the file is missing, damaged or none of ours.
Checkpoint read_checkpoint(const std::filesystem::path& file);

}  // namespace recoat
