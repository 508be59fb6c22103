#include "analyzer/fields/disk_index.hpp"

#include <algorithm>
#include <cmath>

#include "analyzer/fields/contact_graph.hpp"

namespace recoat {

DiskIndex::DiskIndex(double x_min, double x_max, double period, std::size_t expected) : x_min_(x_min), period_(period) {
    const double length = std::max(x_max - x_min, 1e-9), count = static_cast<double>(expected) + 1;
    // About one circle to a cell, but no cell far from square and no more cells than circles along either side.
    const double side = std::max(std::sqrt(length * period / count), std::max(length, period) / (4 * count));
    nx_ = std::max(1, static_cast<int>(length / side));
    ny_ = std::max(1, static_cast<int>(period / side));
    per_x_ = nx_ / length;
    per_y_ = ny_ / period;
    items_.resize(static_cast<std::size_t>(nx_) * ny_);
}

void DiskIndex::add(const Circle& circle, double reach) {
    visit_cells(circle.x, circle.y, reach, [&](std::size_t cell) { items_[cell].push_back(circles_.size()); });
    circles_.push_back(circle);
}

int DiskIndex::column(double x) const {
    return static_cast<int>(std::clamp(std::floor((x - x_min_) * per_x_), 0.0, nx_ - 1.0));
}

int DiskIndex::row(double y) const {
    return static_cast<int>(std::floor(std::clamp(y, -2 * period_, 3 * period_) * per_y_));
}

double DiskIndex::distance(const Circle& circle, double x, double y) const {
    return std::hypot(x - circle.x, nearest_image(y - circle.y, period_));
}

}  // namespace recoat
