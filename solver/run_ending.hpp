#pragma once

#include <filesystem>
#include <string>

#include "solver/output/progress.hpp"
#include "solver/scene/scene.hpp"

namespace recoat {

/// A path as a shell takes it.
std::string quoted(const std::filesystem::path& path);

/// How a stage ended, for a person: "heap: 14 200 steps (1.42 ms), settled.".
std::string stage_ending(const Stage& stage, const StageRecord& record);

/// What a finished run says at its end: what was made and where, and what to do next. Several lines.
std::string run_ending(const Scene& scene, const RunProgress& progress, const std::filesystem::path& folder);

}  // namespace recoat
