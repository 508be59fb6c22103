#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <span>
#include <vector>

#include "analyzer/fields/layer.hpp"

namespace recoat {

/// A disk of the top view, or a copy of it `turn` periods along y [d_p].
struct Disk {
    double x = 0, y = 0, radius = 0;
    std::size_t index = 0;  ///< of the disk in the top view
    int turn = 0;
};

/// A circle of the top view [d_p]; y in one period.
struct Circle {
    double x = 0, y = 0, radius = 0;
};

/// What the order of circles goes by: from large to small, then by x and y; differences that round-off makes do not
/// count.
class CircleKey {
public:
    static constexpr double step = 1e-9;  ///< that lengths are rounded to [d_p]

    CircleKey() = default;
    explicit CircleKey(const Circle& circle);
    /// What counts first; smaller for larger circles.
    [[nodiscard]] double leading() const { return static_cast<double>(values_[0]); }
    friend auto operator<=>(const CircleKey&, const CircleKey&) = default;

private:
    std::array<long long, 3> values_{};
};

[[nodiscard]] bool comes_first(const Circle& a, const Circle& b);

/// Indices of circles in that order; those that are equal in it by their indices.
[[nodiscard]] std::vector<std::size_t> from_large_to_small(std::span<const Circle> circles);

/// The disks of a layer seen from above, whatever their height. Of disks with the same centre the largest stands for
/// all.
///
/// Coordinates and period are rounded to multiples of one power of two (about 1e-12 d_p), so that copies of disks are
/// exact translations and predicates on them give the same answers.
struct TopView {
    std::vector<Disk> disks;
    double period = 0;
    bool equal_radii = true;  ///< within 1e-9 d_p

    /// All disks, and the copies of them within `margin` of the period [0, period].
    [[nodiscard]] std::vector<Disk> tiled(double margin) const;
};

[[nodiscard]] TopView top_view(const Layer& layer);

/// Distance within which centres, and circles, count as the same [d_p].
inline constexpr double coincidence_tolerance = 1e-6;

}  // namespace recoat
