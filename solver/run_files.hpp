#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "solver/output/progress.hpp"
#include "solver/scene/scene.hpp"

namespace recoat {

/// Names of the files that a finished run leaves and that are not in place.
std::vector<std::string> missing_of_finished(const Scene& scene, const std::filesystem::path& folder);

/// Files that a run which has come as far as `progress` should have left, and that are gone.
struct MissingFiles {
    bool last_state = false;          ///< that of the last finished stage, which the checkpoint still holds
    std::vector<std::string> states;  ///< names of others, which nothing can make again
    std::vector<std::string> frames;  ///< of the trajectory: without them it cannot be joined
};

MissingFiles missing_files(const Scene& scene, const std::filesystem::path& folder, const RunProgress& progress);

/// "fill.vtkhdf and heap.vtkhdf"; with more than three names "fill.vtkhdf and 7 more".
std::string list_of(const std::vector<std::string>& names);

}  // namespace recoat
