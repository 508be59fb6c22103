#include "solver/scene/seeding.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

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

/// Cells that hold one sphere at most: their diagonal is shorter than the distance of two centres. y is periodic.
class Occupancy {
public:
    Occupancy(Vec3 lower, Vec3 extent, double distance)
        : lower_(lower), period_(extent.y), distance_(distance), nx_(count(extent.x)), ny_(count(extent.y)) {
        size_x_ = extent.x / nx_;
        size_y_ = extent.y / ny_;
        size_z_ = distance / std::numbers::sqrt3;
    }

    /// Adds a centre unless it is too close to another.
    bool add(Vec3 point) {
        const int ix = std::min(nx_ - 1, static_cast<int>((point.x - lower_.x) / size_x_));
        const int iy = std::min(ny_ - 1, static_cast<int>((point.y - lower_.y) / size_y_));
        const int iz = static_cast<int>((point.z - lower_.z) / size_z_);
        if (!free(point, ix, iy, iz)) return false;
        if (iz >= layers_) {
            layers_ = iz + 1;
            cells_.resize(static_cast<std::size_t>(layers_) * nx_ * ny_, -1);
        }
        cells_[index(ix, iy, iz)] = static_cast<std::int64_t>(points.size());
        points.push_back(point);
        return true;
    }

    std::vector<Vec3> points;

private:
    int count(double length) const {
        return std::max(1, static_cast<int>(std::ceil(length / (distance_ / std::numbers::sqrt3))));
    }
    std::size_t index(int ix, int iy, int iz) const { return (static_cast<std::size_t>(iz) * ny_ + iy) * nx_ + ix; }

    bool free(Vec3 point, int ix, int iy, int iz) const {
        const int reach_x = static_cast<int>(std::ceil(distance_ / size_x_));
        const int reach_y = std::min(static_cast<int>(std::ceil(distance_ / size_y_)), (ny_ - 1) / 2 + 1);
        for (int jz = std::max(0, iz - 2); jz <= std::min(layers_ - 1, iz + 2); ++jz) {
            for (int dy = -reach_y; dy <= reach_y; ++dy) {
                const int jy = ((iy + dy) % ny_ + ny_) % ny_;
                for (int jx = std::max(0, ix - reach_x); jx <= std::min(nx_ - 1, ix + reach_x); ++jx) {
                    const std::int64_t other = cells_[index(jx, jy, jz)];
                    if (other >= 0 && too_close(point, points[static_cast<std::size_t>(other)])) return false;
                }
            }
        }
        return true;
    }

    bool too_close(Vec3 a, Vec3 b) const {
        Vec3 d = a - b;
        d.y -= period_ * std::round(d.y / period_);
        return squared_norm(d) < distance_ * distance_;
    }

    Vec3 lower_;
    double period_, distance_;
    int nx_, ny_, layers_ = 0;
    double size_x_, size_y_, size_z_;
    std::vector<std::int64_t> cells_;
};

}  // namespace

ParticleTable seed_column(const ColumnSource& column, double diameter, double y_period) {
    const double margin = (0.5 + gap) * diameter;
    const double distance = (1 + gap) * diameter;
    const Vec3 lower{column.x_lower + margin, 0, margin};
    const double width = column.x_upper - column.x_lower - 2 * margin;
    const double volume = std::numbers::pi / 6 * diameter * diameter * diameter * static_cast<double>(column.count);
    const double area = (column.x_upper - column.x_lower) * y_period;
    double height = std::max(diameter, volume / (column.packing_density * area));

    Uniform uniform(column.seed);
    Occupancy occupied(lower, {width, y_period, 0}, distance);
    while (static_cast<std::int64_t>(occupied.points.size()) < column.count) {
        bool placed = false;
        for (int attempt = 0; attempt < tries && !placed; ++attempt) {
            const double x = lower.x + width * uniform();
            const double y = y_period * uniform();
            placed = occupied.add({x, y, lower.z + height * uniform()});
        }
        if (!placed) height += diameter;
    }

    ParticleTable table;
    table.position = std::move(occupied.points);
    table.velocity.resize(table.position.size());
    table.angular_velocity.resize(table.position.size());
    table.radius.assign(table.position.size(), 0.5 * diameter);
    return table;
}

}  // namespace recoat
