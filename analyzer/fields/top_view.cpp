#include "analyzer/fields/top_view.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "analyzer/fields/coincidence.hpp"
#include "analyzer/fields/sort_in_pieces.hpp"

namespace recoat {
namespace {

constexpr double equal_radii_tolerance = 1e-9;

/// Step of the coordinates: the largest of them, and copies of it, keep all their bits.
double coordinate_step(const Layer& layer) {
    double largest = 4 * layer.width;
    for (const double x : layer.x) largest = std::max(largest, std::abs(x));
    constexpr int bits = 51;
    return std::ldexp(1.0, std::ilogb(largest) + 1 - bits);
}

}  // namespace

CircleKey::CircleKey(const Circle& circle) {
    values_ = {-std::llround(circle.radius / step), std::llround(circle.x / step), std::llround(circle.y / step)};
}

bool comes_first(const Circle& a, const Circle& b) {
    // Most pairs differ by more than the steps of their keys.
    if (std::abs(a.radius - b.radius) > 2 * CircleKey::step) return a.radius > b.radius;
    return CircleKey(a) < CircleKey(b);
}

std::vector<std::size_t> from_large_to_small(std::span<const Circle> circles) {
    struct Entry {
        CircleKey key;
        std::size_t index;
    };
    std::vector<Entry> entries;
    entries.reserve(circles.size());
    for (const Circle& circle : circles) entries.push_back({CircleKey(circle), entries.size()});
    sort_in_pieces(
        entries, [](const Entry& entry) { return entry.key.leading(); },
        [](const Entry& a, const Entry& b) { return std::tie(a.key, a.index) < std::tie(b.key, b.index); });
    std::vector<std::size_t> order(entries.size());
    std::ranges::transform(entries, order.begin(), &Entry::index);
    return order;
}

TopView top_view(const Layer& layer) {
    TopView view;
    const double step = coordinate_step(layer);
    const auto rounded = [&](double value) { return std::nearbyint(value / step) * step; };
    view.period = rounded(layer.width);
    std::vector<PlanePoint> centres(layer.size());
    for (std::size_t i = 0; i < layer.size(); ++i) {
        const double y = rounded(layer.y[i]);
        centres[i] = {rounded(layer.x[i]), y < view.period ? y : y - view.period};
    }
    const std::vector<std::size_t> first = first_coincident(centres, view.period, coincidence_tolerance);
    std::vector<double> radius(layer.size(), 0);
    for (std::size_t i = 0; i < layer.size(); ++i) radius[first[i]] = std::max(radius[first[i]], layer.radius[i]);
    for (std::size_t i = 0; i < layer.size(); ++i) {
        if (first[i] == i) view.disks.push_back({centres[i].x, centres[i].y, radius[i], view.disks.size(), 0});
    }
    if (!view.disks.empty()) {
        const auto [low, high] = std::ranges::minmax(layer.radius);
        view.equal_radii = high - low <= equal_radii_tolerance;
    }
    return view;
}

std::vector<Disk> TopView::tiled(double margin) const {
    std::vector<Disk> copies = disks;
    const int turns = static_cast<int>(std::ceil(margin / period)) + 1;
    for (int turn = -turns; turn <= turns; ++turn) {
        if (turn == 0) continue;
        for (Disk copy : disks) {
            copy.y += turn * period;
            copy.turn = turn;
            if (copy.y >= -margin && copy.y <= period + margin) copies.push_back(copy);
        }
    }
    return copies;
}

}  // namespace recoat
