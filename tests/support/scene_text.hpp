#pragma once

#include <string>
#include <vector>

#include "common/config.hpp"
#include "solver/scene/read_scene.hpp"
#include "solver/scene/scene.hpp"

namespace recoat::testing {

/// The paper's material and contact [paper Table 1].
inline const std::string model_text =
    "material: {diameter: 50 um, density: 4430 kg/m3, young_modulus: 110 GPa, poisson_ratio: 0.3}\n"
    "contact: {restitution: 0.4, sliding_friction: 0.3, rolling_friction: 0.01}\n"
    "gravity: 9.81 m/s2\n"
    "time_step: 2e-8 s\n";

/// A small spreading scene.
inline const std::string spread_text =
    "scene: spread\n"
    "stiffness_ratio: 0.001\n" +
    model_text +
    "powder: {particles: 40}\n"
    "box: {length: 60 dp, width: 6 dp, fill_length: 6 dp}\n"
    "blade: {clearance: 1.5 dp, speed: 50 mm/s}\n"
    "stages:\n"
    "  - fill: {settle_time: 10 ms}\n"
    "  - heap: {settle_time: 20 ms}\n"
    "  - spread: {length: 20 dp, settle_time: 5 ms}\n";

inline Scene scene_of(const std::string& text, const std::vector<std::string>& settings = {},
                      const std::filesystem::path& folder = {}) {
    return read_scene(Config::parse(text, "scene.yaml", settings), folder);
}

}  // namespace recoat::testing
