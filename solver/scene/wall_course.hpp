#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "solver/engine/wall.hpp"
#include "solver/scene/stage.hpp"

namespace recoat {

struct Scene;

/// Follows the walls of a scene through its stages, so that what cannot work is known before the run.
class WallCourse {
public:
    /// Needs walls, time step and geometry of `scene`.
    explicit WallCourse(const Scene& scene);

    /// Walls as they stand now; those that were removed are not active.
    [[nodiscard]] const std::vector<Wall>& walls() const { return walls_; }
    /// Whether there is such a wall now.
    [[nodiscard]] bool stands(std::string_view name) const;
    /// The wall of this name; one that never was there is a bug.
    [[nodiscard]] const Wall& wall(std::string_view name) const;

    /// Takes the walls through `segment`. Returns what cannot work in it, and what to do; empty when nothing is wrong.
    [[nodiscard]] std::string follow(const Segment& segment);

private:
    [[nodiscard]] std::string remove(const std::string& name);
    [[nodiscard]] std::string leaves_domain(const Wall& wall) const;
    [[nodiscard]] std::string meeting(const std::vector<Wall>& before) const;

    bool bounded_;  ///< the domain ends at base, rear and front, as in scenes of kind spread
    double time_step_, diameter_;
    std::vector<Wall> walls_;
};

}  // namespace recoat
