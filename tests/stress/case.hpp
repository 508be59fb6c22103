#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace recoat::stress {

/// A scene as the files that a user would write.
struct Case {
    std::string scene;         ///< content of scene.yaml
    std::string table;         ///< content of particles.csv; empty: the scene makes its own particles
    bool empty_state = false;  ///< it starts from start.vtkhdf, a state without particles
    std::string character;     ///< what is special about it, for the tally
    double step_share = 0;     ///< time step over the stability limit at the speeds of the scene
};

/// Scene number `index` of the run with `seed`: the same on every machine.
Case draw_case(std::uint64_t seed, std::uint64_t index);

/// Writes scene.yaml and, where there is one, particles.csv.
void write_case(const Case& scene, const std::filesystem::path& folder);

}  // namespace recoat::stress
