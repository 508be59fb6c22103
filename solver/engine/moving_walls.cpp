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
    for (std::size_t w = 0; w < now_.size(); ++w) {
        const Wall& from = anchor_[w];
        if (from.velocity == Vec3{}) continue;
        const Vec3 way = static_cast<double>(step - since_[w]) * time_step * from.velocity;
        now_[w].point = from.point + way;
        now_[w].lower = from.lower + way;
        now_[w].upper = from.upper + way;
    }
}

}  // namespace recoat
