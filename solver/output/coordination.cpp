#include "solver/output/coordination.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace recoat {
namespace {

constexpr double reach = 1.005;

/// Counts by a sweep along x: only particles whose x is within reach are looked at.
class Sweep {
public:
    Sweep(const ParticleTable& particles, double y_period)
        : particles_(particles), y_period_(y_period), order_(particles.size()) {
        std::iota(order_.begin(), order_.end(), std::size_t{0});
        std::ranges::sort(order_, {}, [&](std::size_t i) { return particles.position[i].x; });
        largest_ = particles.size() == 0 ? 0 : std::ranges::max(particles.radius);
    }

    std::vector<double> count() const {
        std::vector<double> result(particles_.size(), 0.0);
        for (std::size_t a = 0; a < order_.size(); ++a) {
            const std::size_t i = order_[a];
            const double end = particles_.position[i].x + reach * (particles_.radius[i] + largest_);
            for (std::size_t b = a + 1; b < order_.size() && particles_.position[order_[b]].x < end; ++b) {
                const std::size_t j = order_[b];
                if (!touch(i, j)) continue;
                result[i] += 1;
                result[j] += 1;
            }
        }
        return result;
    }

private:
    bool touch(std::size_t i, std::size_t j) const {
        Vec3 d = particles_.position[i] - particles_.position[j];
        if (y_period_ > 0) d.y -= y_period_ * std::round(d.y / y_period_);
        const double limit = reach * (particles_.radius[i] + particles_.radius[j]);
        return squared_norm(d) < limit * limit;
    }

    const ParticleTable& particles_;
    double y_period_, largest_;
    std::vector<std::size_t> order_;
};

}  // namespace

std::vector<double> coordination_numbers(const ParticleTable& particles, double y_period) {
    return Sweep(particles, y_period).count();
}

}  // namespace recoat
