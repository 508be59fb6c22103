#pragma once

#include <cstdint>
#include <filesystem>
#include <utility>
#include <vector>

#include "solver/engine/engine.hpp"
#include "solver/output/wall_polygons.hpp"

namespace recoat {

/// Where the walls were at the times of the states.
class WallSeries {
public:
    /// Adds the walls of the moment, once per step.
    void add(const Engine& engine);
    [[nodiscard]] bool empty() const { return values_.empty(); }

    /// Everything as numbers, and back.
    [[nodiscard]] const std::vector<double>& values() const { return values_; }
    void set_values(std::vector<double> values);

    /// Writes polygons to a VTKHDF file with a step for each time, as ParaView shows them beside the particles. Every
    /// polygon has the number of its wall (`Wall`, in the order of the scene). Walls end where `scene_domain` does;
    /// where that is infinite, half a `diameter` [m] beyond all particles, along z four diameters above them.
    void write(const std::filesystem::path& file, const DrawnSpace& scene_domain, double diameter) const;

private:
    std::vector<double> values_;
    std::int64_t last_ = -1;  ///< step of the last row
};

}  // namespace recoat
