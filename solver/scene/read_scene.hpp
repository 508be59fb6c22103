#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "common/config.hpp"
#include "solver/scene/scene.hpp"

namespace recoat {

/// Reads a whole scene; relative file names in it start from `folder`. Throws InputError "file:line: key: sentence".
Scene read_scene(Config config, const std::filesystem::path& folder);

/// Reads a scene file with the texts of --set.
Scene load_scene(const std::filesystem::path& file, std::span<const std::string> overrides = {});

}  // namespace recoat
