#include "solver/scene/crowd.hpp"

#include <algorithm>
#include <cmath>

namespace recoat {
namespace {

/// Cells no shorter than `reach`, so that only neighbours matter.
std::int64_t count(double length, double reach) {
    return std::max<std::int64_t>(1, static_cast<std::int64_t>(length / reach));
}

}  // namespace

Crowd::Crowd(Vec3 lower, Vec3 extent, double reach, double gap)
    : lower_(lower), period_(extent.y), gap_(gap), nx_(count(extent.x, reach)), ny_(count(extent.y, reach)) {
    side_x_ = extent.x / static_cast<double>(nx_);
    side_y_ = extent.y / static_cast<double>(ny_);
    side_z_ = reach;
}

bool Crowd::add(Vec3 centre, double radius) {
    const auto cell = [](double way, double side) {
        return side > 0 ? static_cast<std::int64_t>(std::floor(way / side)) : 0;
    };
    const std::int64_t at[3] = {std::clamp<std::int64_t>(cell(centre.x - lower_.x, side_x_), 0, nx_ - 1),
                                std::clamp<std::int64_t>(cell(centre.y - lower_.y, side_y_), 0, ny_ - 1),
                                std::max<std::int64_t>(0, cell(centre.z - lower_.z, side_z_))};
    if (!has_room(centre, radius, at)) return false;
    const std::size_t place = index(at[0], at[1], at[2]);
    if (place >= cells_.size()) cells_.resize(index(0, 0, at[2] + 1));
    cells_[place].push_back({centre, radius});
    return true;
}

bool Crowd::has_room(Vec3 centre, double radius, const std::int64_t (&cell)[3]) const {
    const auto layers = static_cast<std::int64_t>(cells_.size()) / (nx_ * ny_);
    const std::int64_t around = std::min<std::int64_t>(3, ny_);  // fewer rows than three are each met once
    for (std::int64_t z = std::max<std::int64_t>(0, cell[2] - 1); z <= std::min(layers - 1, cell[2] + 1); ++z) {
        for (std::int64_t k = 0; k < around; ++k) {
            const std::int64_t y = (cell[1] + ny_ - 1 + k) % ny_;
            for (std::int64_t x = std::max<std::int64_t>(0, cell[0] - 1); x <= std::min(nx_ - 1, cell[0] + 1); ++x) {
                for (const Sphere& other : cells_[index(x, y, z)]) {
                    if (too_close(other, centre, radius)) return false;
                }
            }
        }
    }
    return true;
}

bool Crowd::too_close(const Sphere& sphere, Vec3 centre, double radius) const {
    Vec3 d = centre - sphere.centre;
    d.y -= period_ * std::round(d.y / period_);
    const double distance = radius + sphere.radius + gap_;
    return squared_norm(d) < distance * distance;
}

}  // namespace recoat
