#include "analyzer/fields/cell_list.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace recoat {
namespace {

int boxes(double extent, double side) { return static_cast<int>(std::clamp(std::floor(extent / side), 1.0, 1e6)); }

}  // namespace

CellList::CellList(const Layer& layer, double reach) : layer_(layer) {
    if (layer.size() == 0) {
        start_.assign(2, 0);
        return;
    }
    const auto [x_low, x_high] = std::ranges::minmax(layer.x);
    const auto [z_low, z_high] = std::ranges::minmax(layer.z);
    x_min_ = x_low;
    z_min_ = z_low;
    const double limit = 4.0 * static_cast<double>(layer.size()) + 64;
    for (double side = reach * (1 + 1e-9);; side *= 1.26) {
        nx_ = boxes(x_high - x_low, side);
        ny_ = boxes(layer.width, side);
        nz_ = boxes(z_high - z_low, side);
        if (static_cast<double>(nx_) * ny_ * nz_ <= limit) break;
    }
    per_x_ = x_high > x_low ? nx_ / (x_high - x_low) : 0;
    per_y_ = ny_ / layer.width;
    per_z_ = z_high > z_low ? nz_ / (z_high - z_low) : 0;
    start_.assign(static_cast<std::size_t>(nx_) * ny_ * nz_ + 1, 0);
    for (std::size_t p = 0; p < layer.size(); ++p) ++start_[flat(cell_of(p)) + 1];
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    item_.resize(layer.size());
    std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
    for (std::size_t p = 0; p < layer.size(); ++p) item_[next[flat(cell_of(p))]++] = p;
}

CellList::Index CellList::cell_of(std::size_t particle) const {
    return {std::min(static_cast<int>((layer_.x[particle] - x_min_) * per_x_), nx_ - 1),
            std::min(static_cast<int>(layer_.y[particle] * per_y_), ny_ - 1),
            std::min(static_cast<int>((layer_.z[particle] - z_min_) * per_z_), nz_ - 1)};
}

}  // namespace recoat
