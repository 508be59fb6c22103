#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "solver/engine/engine.hpp"
#include "solver/output/progress.hpp"
#include "solver/scene/scene.hpp"

namespace recoat {

enum class RunStatus { finished, stopped };

/// Writes DIR/summary.json: what was run, every finished stage, the energy ledger and its balance. SI units; overlaps
/// in d_p. Apart from wall-clock times, rates and resources it depends on the scene only.
void write_summary(const std::filesystem::path& file, const Scene& scene, const RunProgress& progress,
                   const Engine& engine, RunStatus status, const Resources& resources);

/// What an earlier run left in a folder.
struct EarlierSummary {
    std::string config, version;
    bool finished = false;
};

/// Nothing when there is no such file. Throws InputError when it is no summary of ours.
std::optional<EarlierSummary> read_summary(const std::filesystem::path& file);

}  // namespace recoat
