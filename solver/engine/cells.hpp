#pragma once

#include <cstdint>
#include <vector>

#include "solver/engine/particles.hpp"

namespace recoat {

/// A grid of cells over the particles, periodic in y when there is a period; x runs fastest.
class Cells {
public:
    /// `side` is the least cell size; cells grow where there would be many more of them than particles.
    Cells(const std::vector<Row>& position, double side, double y_min, double y_period);

    [[nodiscard]] std::int64_t count() const { return count_[0] * count_[1] * count_[2]; }
    [[nodiscard]] std::int64_t along(int axis) const { return count_[axis]; }
    [[nodiscard]] bool periodic() const { return periodic_; }
    [[nodiscard]] std::int64_t coordinate(int axis, const Row& position) const;
    [[nodiscard]] std::int64_t key(std::int64_t x, std::int64_t y, std::int64_t z) const {
        return (y * count_[2] + z) * count_[0] + x;
    }
    [[nodiscard]] std::int64_t key(const Row& p) const {
        return key(coordinate(0, p), coordinate(1, p), coordinate(2, p));
    }

private:
    double lower_[3], inverse_[3];
    std::int64_t count_[3];
    bool periodic_;
};

}  // namespace recoat
