#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "common/config.hpp"
#include "solver/scene/scene.hpp"

namespace recoat {

/// Smallest and largest diameter of the particles of a table or state [m].
struct DiameterBounds {
    double smallest = 0, largest = 0;
};

/// Reads a whole scene; relative file names in it start from `folder`. `diameters`: of particles that another file has.
/// Throws InputError "file:line: key: sentence".
Scene read_scene(Config config, const std::filesystem::path& folder, std::optional<DiameterBounds> diameters = {});

/// Reads a scene file with the texts of --set, and the sizes of particles that come from a table or state file. The
/// resolved configuration ends with a comment that identifies the content of the table or state file that the particles
/// come from.
Scene load_scene(const std::filesystem::path& file, std::span<const std::string> overrides = {});

}  // namespace recoat
