#include "solver/engine/moving_walls.hpp"

#include <algorithm>

namespace recoat {

double MovingWalls::fastest() const {
    double speed = 0;
    for (const Wall& wall : now_)
        if (wall.active) speed = std::max(speed, norm(wall.velocity));
    return speed;
}

void MovingWalls::drive(std::size_t wall, Vec3 velocity, std::int64_t step) {
    now_.at(wall).velocity = velocity;
    anchor_[wall] = now_[wall];
    since_[wall] = step;
}

void MovingWalls::remove(std::size_t wall) {
    now_.at(wall).active = false;
    now_[wall].velocity = {};
    anchor_[wall] = now_[wall];
}

void MovingWalls::move(std::int64_t step, double time_step) {
    const std::vector<WallAnchor> from = anchors();
    for (std::size_t w = 0; w < now_.size(); ++w) {
        if (from[w].velocity == Vec3{}) continue;
        const Vec3 way = from[w].way(step, time_step);
        now_[w].point = from[w].point + way;
        now_[w].lower = from[w].lower + way;
        now_[w].upper = from[w].upper + way;
    }
}

std::vector<WallAnchor> MovingWalls::anchors() const {
    std::vector<WallAnchor> anchors;
    for (std::size_t w = 0; w < now_.size(); ++w) {
        const Wall& wall = anchor_[w];
        anchors.push_back(
            {wall.point, wall.normal, wall.lower, wall.upper, wall.velocity, since_[w], wall.kind, wall.active});
    }
    return anchors;
}

}  // namespace recoat
