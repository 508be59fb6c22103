#include "solver/engine/cells.hpp"

#include <algorithm>
#include <cmath>

namespace recoat {

Cells::Cells(const std::vector<Row>& position, double side, double y_min, double y_period) : periodic_(y_period > 0) {
    double upper[3] = {0, 0, 0};
    lower_[0] = lower_[1] = lower_[2] = 0;
    if (!position.empty()) {
        const Row& p = position.front();
        lower_[0] = upper[0] = p.x;
        lower_[1] = upper[1] = p.y;
        lower_[2] = upper[2] = p.z;
    }
    for (const Row& p : position) {
        const double x[3] = {p.x, p.y, p.z};
        for (int a = 0; a < 3; ++a) {
            lower_[a] = std::min(lower_[a], x[a]);
            upper[a] = std::max(upper[a], x[a]);
        }
    }
    if (periodic_) {
        lower_[1] = y_min;
        upper[1] = y_min + y_period;
    }
    const double most = 8.0 * static_cast<double>(position.size()) + 1000;
    double volume = 1;
    for (int a = 0; a < 3; ++a) volume *= std::floor((upper[a] - lower_[a]) / side) + 1;
    const double growth = volume > most ? std::cbrt(volume / most) + 1 : 1;
    for (int a = 0; a < 3; ++a) {
        const double extent = upper[a] - lower_[a];
        const double fit = std::floor(extent / (side * growth));
        count_[a] = std::max<std::int64_t>(1, static_cast<std::int64_t>(fit));
        inverse_[a] = extent > 0 ? static_cast<double>(count_[a]) / extent : 0;
    }
}

std::int64_t Cells::coordinate(int axis, const Row& position) const {
    const double x = axis == 0 ? position.x : axis == 1 ? position.y : position.z;
    const auto cell = static_cast<std::int64_t>(std::floor((x - lower_[axis]) * inverse_[axis]));
    return std::clamp<std::int64_t>(cell, 0, count_[axis] - 1);
}

}  // namespace recoat
