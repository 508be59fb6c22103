#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "solver/scene/scene.hpp"

namespace recoat {

/// One run of a sweep.
struct SweepCase {
    std::string name;              ///< the folder as the file has it
    std::filesystem::path folder;  ///< for the results
    Scene scene;
};

/// Reads a sweep file and every scene in it:
///
///     scene: scene.yaml                              # of all cases that name no other
///     cases:
///       - {out: bond-5, set: [cohesion.bond_number=5]}
///       - {out: bond-50, set: [cohesion.bond_number=50], scene: other.yaml}
///
/// Relative paths start from the folder of the file. Throws InputError "file:line: key: sentence", also for a scene
/// that cannot be read and for two cases with the same folder.
std::vector<SweepCase> read_sweep(const std::filesystem::path& file);

}  // namespace recoat
