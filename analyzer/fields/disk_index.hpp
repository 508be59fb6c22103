#pragma once

#include <cstddef>
#include <vector>

#include "analyzer/fields/top_view.hpp"

namespace recoat {

/// Circles sorted into the cells of a grid that they reach into, periodic along y; for the question which of them are
/// near a place.
class DiskIndex {
public:
    /// For circles with centres in [x_min, x_max].
    DiskIndex(double x_min, double x_max, double period, std::size_t expected);

    /// Adds a circle to the cells within `reach` of its centre.
    void add(const Circle& circle, double reach);

    /// Whether holds(circle, distance) for any circle added to the cells within `reach` of a place; distance of the
    /// centres, nearest images.
    template <class Holds>
    [[nodiscard]] bool any_near(double x, double y, double reach, Holds holds) const {
        bool found = false;
        visit_cells(x, y, reach, [&](std::size_t cell) {
            for (std::size_t k = 0; k < items_[cell].size() && !found; ++k) {
                const Circle& circle = circles_[items_[cell][k]];
                found = holds(circle, distance(circle, x, y));
            }
        });
        return found;
    }

private:
    template <class Visit>
    void visit_cells(double x, double y, double reach, Visit visit) const {
        const int i_low = column(x - reach), i_high = column(x + reach);
        int j_low = row(y - reach), j_high = row(y + reach);
        if (j_high - j_low >= ny_) {
            j_low = 0;
            j_high = ny_ - 1;
        }
        for (int i = i_low; i <= i_high; ++i) {
            for (int j = j_low; j <= j_high; ++j) {
                visit(static_cast<std::size_t>(i) * ny_ + static_cast<std::size_t>(((j % ny_) + ny_) % ny_));
            }
        }
    }
    [[nodiscard]] int column(double x) const;
    [[nodiscard]] int row(double y) const;
    [[nodiscard]] double distance(const Circle& circle, double x, double y) const;

    double x_min_, period_, per_x_, per_y_;
    int nx_, ny_;
    std::vector<std::vector<std::size_t>> items_;
    std::vector<Circle> circles_;
};

}  // namespace recoat
