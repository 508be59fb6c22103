#include "solver/scene/seeding.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <random>

#include "solver/scene/crowd.hpp"

namespace recoat {
namespace {

constexpr double gap = 0.01;  ///< smallest distance of surfaces [d_p]
constexpr int tries = 20000;  ///< per sphere, before the column grows by one diameter

/// Uniform in [0, 1) with 53 bits, unlike std::uniform_real_distribution the same in every library.
class Uniform {
public:
    explicit Uniform(std::int64_t seed) : generator_(static_cast<std::uint64_t>(seed)) {}
    double operator()() { return static_cast<double>(generator_() >> 11) * 0x1.0p-53; }

private:
    std::mt19937_64 generator_;
};

std::vector<double> radii_of(const ColumnSource& column, double diameter) {
    std::vector<double> radii(static_cast<std::size_t>(column.count), 0.5 * diameter);
    if (!column.sizes) return radii;
    Uniform uniform(column.seed ^ 0x5bd1e995);  // another stream than that of the places
    for (double& radius : radii) radius = 0.5 * column.sizes->diameter(uniform());
    return radii;
}

/// Indices from the largest to the smallest sphere: the small ones find room between the large ones.
std::vector<std::size_t> order_of_placing(const std::vector<double>& radii) {
    std::vector<std::size_t> order(radii.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::greater<>(), [&](std::size_t i) { return radii[i]; });
    return order;
}

/// Height of the column at the stated density, one largest sphere at least.
double height_of(const ColumnSource& column, const std::vector<double>& radii, double y_period) {
    double volume = 0;
    for (const double radius : radii) volume += 4 * std::numbers::pi / 3 * radius * radius * radius;
    const double area = (column.x_upper - column.x_lower) * y_period;
    return std::max(2 * std::ranges::max(radii), volume / (column.packing_density * area));
}

}  // namespace

ParticleTable seed_column(const ColumnSource& column, double diameter, double y_period) {
    ParticleTable table;
    table.radius = radii_of(column, diameter);
    table.position.resize(table.radius.size());
    table.velocity.resize(table.radius.size());
    table.angular_velocity.resize(table.radius.size());
    double height = height_of(column, table.radius, y_period);
    const double width = column.x_upper - column.x_lower, space = gap * diameter;
    Crowd crowd({column.x_lower, 0, 0}, {width, y_period, 0}, 2 * std::ranges::max(table.radius) + space, space);
    Uniform uniform(column.seed);
    for (const std::size_t i : order_of_placing(table.radius)) {
        const double margin = table.radius[i] + space;
        for (int attempt = 1;; ++attempt) {
            const double x = column.x_lower + margin + (width - 2 * margin) * uniform();
            const double y = y_period * uniform();
            table.position[i] = {x, y, margin + height * uniform()};
            if (crowd.add(table.position[i], table.radius[i])) break;
            if (attempt % tries == 0) height += diameter;
        }
    }
    return table;
}

}  // namespace recoat
