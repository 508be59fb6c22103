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

/// Writes FOLDER/checkpoint.h5 whole or not at all; the one that was there becomes checkpoint-previous.h5. Throws
/// InputError when the file cannot be written.
void write_checkpoint(const std::filesystem::path& folder, const Checkpoint& checkpoint);

/// Throws InputError when the file is missing, damaged (by a single bit, too) or none of ours.
Checkpoint read_checkpoint(const std::filesystem::path& file);

/// The checkpoint to continue from.
struct LatestCheckpoint {
    Checkpoint checkpoint;
    std::string note;  ///< a sentence when it is the earlier one, and why
};

/// The last whole checkpoint of a folder: the earlier one where the last is missing or damaged. Throws InputError when
/// neither can be used.
LatestCheckpoint read_latest_checkpoint(const std::filesystem::path& folder);

/// Whether there is any, whole or damaged.
bool has_checkpoint(const std::filesystem::path& folder);

/// Removes both.
void remove_checkpoints(const std::filesystem::path& folder);

}  // namespace recoat
