#pragma once

#include <cstdint>
#include <vector>

#include "solver/engine/wall.hpp"

namespace recoat {

/// Walls and where they are now.
class MovingWalls {
public:
    MovingWalls() = default;
    explicit MovingWalls(std::vector<Wall> walls) : now_(walls), anchor_(std::move(walls)), since_(now_.size(), 0) {}
    MovingWalls(std::vector<Wall> now, std::vector<Wall> anchor, std::vector<std::int64_t> since)
        : now_(std::move(now)), anchor_(std::move(anchor)), since_(std::move(since)) {}

    [[nodiscard]] const std::vector<Wall>& now() const { return now_; }
    [[nodiscard]] const std::vector<Wall>& anchor() const { return anchor_; }
    [[nodiscard]] const std::vector<std::int64_t>& since() const { return since_; }

    /// The same for loops that know the step.
    [[nodiscard]] std::vector<WallAnchor> anchors() const;

    /// Largest speed of an active wall [m/s].
    [[nodiscard]] double fastest() const;

    void drive(std::size_t wall, Vec3 velocity, std::int64_t step);
    void remove(std::size_t wall);
    void move(std::int64_t step, double time_step);

private:
    std::vector<Wall> now_, anchor_;
    std::vector<std::int64_t> since_;
};

}  // namespace recoat
