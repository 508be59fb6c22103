#include "analyzer/fields/spatial_order.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

#include "analyzer/fields/parallel.hpp"

namespace recoat {
namespace {

/// Boxes with some ten particles each over the centres of a layer in the top view.
class Boxes {
public:
    explicit Boxes(const Layer& layer) : layer_(layer) {
        const auto [low, high] = std::ranges::minmax(layer.x);
        const double length = high - low, wanted = static_cast<double>(layer.size()) / 10 + 1;
        const double side = std::max(std::sqrt(length * layer.width / wanted), length / wanted);
        x_min_ = low;
        nx_ = side > 0 ? static_cast<std::uint32_t>(length / side) + 1 : 1;
        ny_ = side > 0 ? static_cast<std::uint32_t>(std::min(layer.width / side, wanted)) + 1 : 1;
        per_x_ = length > 0 ? nx_ / length : 0;
        per_y_ = ny_ / layer.width;
    }
    [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(nx_) * ny_; }
    [[nodiscard]] std::size_t of(std::size_t particle) const {
        const auto i = std::min(static_cast<std::uint32_t>((layer_.x[particle] - x_min_) * per_x_), nx_ - 1);
        const auto j = std::min(static_cast<std::uint32_t>(layer_.y[particle] * per_y_), ny_ - 1);
        return static_cast<std::size_t>(i) * ny_ + j;
    }

private:
    const Layer& layer_;
    double x_min_ = 0, per_x_ = 0, per_y_ = 0;
    std::uint32_t nx_ = 1, ny_ = 1;
};

template <class Value>
std::vector<Value> gathered(const std::vector<Value>& values, const std::vector<std::size_t>& from) {
    std::vector<Value> result(from.size());
    for_each_in_parallel(from.size(), [&](std::size_t i) { result[i] = values[from[i]]; });
    return result;
}

}  // namespace

SpatialOrder::SpatialOrder(const Layer& layer) : particle_(layer.size()), place_(layer.size()) {
    if (layer.size() == 0) return;
    const Boxes boxes(layer);
    std::vector<std::size_t> next(boxes.count() + 1, 0);
    for (std::size_t p = 0; p < layer.size(); ++p) ++next[boxes.of(p) + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    for (std::size_t p = 0; p < layer.size(); ++p) {
        place_[p] = next[boxes.of(p)]++;
        particle_[place_[p]] = p;
    }
}

Layer SpatialOrder::apply(const Layer& layer) const {
    Layer result;
    result.x = gathered(layer.x, particle_);
    result.y = gathered(layer.y, particle_);
    result.z = gathered(layer.z, particle_);
    result.radius = gathered(layer.radius, particle_);
    result.in_region = gathered(layer.in_region, particle_);
    result.file_index = gathered(layer.file_index, particle_);
    result.length = layer.length;
    result.width = layer.width;
    result.clearance = layer.clearance;
    result.grid = layer.grid;
    return result;
}

std::vector<std::uint32_t> SpatialOrder::coordination_numbers(const ContactGraph& graph) const {
    std::vector<std::uint32_t> number(particle_.size());
    for (std::size_t place = 0; place < particle_.size(); ++place) {
        number[particle_[place]] = static_cast<std::uint32_t>(graph.coordination_number(place));
    }
    return number;
}

Clusters SpatialOrder::restore(const Clusters& clusters) const {
    constexpr std::size_t unseen = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> number(clusters.cluster.size(), unseen);
    Clusters result;
    result.cluster.reserve(clusters.cluster.size());
    result.of_particle.resize(place_.size());
    for (std::size_t p = 0; p < place_.size(); ++p) {
        const std::size_t found = clusters.of_particle[place_[p]];
        if (number[found] == unseen) {
            number[found] = result.cluster.size();
            result.cluster.push_back(clusters.cluster[found]);
        }
        result.of_particle[p] = number[found];
    }
    return result;
}

}  // namespace recoat
