#include "analyzer/metrics/pore_errors.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <span>
#include <stdexcept>
#include <tuple>

#include "analyzer/fields/grid_pores.hpp"
#include "analyzer/metrics/box_stats.hpp"

namespace recoat {
namespace {

PoreErrors summary(std::span<const double> differences, std::size_t exact, std::size_t pixels) {
    PoreErrors errors{differences.size(), exact - differences.size(), pixels - differences.size(), {}};
    if (differences.empty()) return errors;
    const double bias = mean(differences);
    double squares = 0;
    for (const double difference : differences) squares += (difference - bias) * (difference - bias);
    errors.size = {bias, std::sqrt(squares / static_cast<double>(differences.size()))};
    return errors;
}

struct Pair {
    double distance;
    std::size_t exact, pixel;

    friend bool operator<(const Pair& a, const Pair& b) {
        return std::tie(a.distance, a.exact, a.pixel) < std::tie(b.distance, b.exact, b.pixel);
    }
};

/// All pairs within reach, of circles sorted by x.
std::vector<Pair> near_pairs(const std::vector<Circle>& exact, const std::vector<Circle>& pixels, double period,
                             double reach) {
    std::vector<std::size_t> order(pixels.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    std::ranges::sort(order, {}, [&](std::size_t k) { return pixels[k].x; });
    const auto x_of = [&](std::size_t k) { return pixels[k].x; };
    std::vector<Pair> pairs;
    for (std::size_t e = 0; e < exact.size(); ++e) {
        const auto begin = std::ranges::lower_bound(order, exact[e].x - reach, {}, x_of);
        const auto end = std::ranges::upper_bound(order, exact[e].x + reach, {}, x_of);
        for (auto k = begin; k != end; ++k) {
            const double gap_y = std::abs(exact[e].y - pixels[*k].y);
            const double distance = std::hypot(exact[e].x - pixels[*k].x, std::min(gap_y, period - gap_y));
            if (distance <= reach) pairs.push_back({distance, e, *k});
        }
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

/// For each pore of one map the pore of the other with which it shares the most cells, the first of several.
constexpr std::size_t nobody = static_cast<std::size_t>(-1);
std::vector<std::size_t> best_partners(const std::vector<GridPore>& pores, const std::vector<GridPore>& others,
                                       const Map& map) {
    const auto place = [&](GridCell cell) {
        return static_cast<std::size_t>(cell.ix) * map.ny +
               static_cast<std::size_t>(((cell.iy % map.ny) + map.ny) % map.ny);
    };
    std::vector<std::size_t> owner(map.values.size(), nobody);
    for (std::size_t k = 0; k < others.size(); ++k) {
        for (const GridCell cell : others[k].cells) owner[place(cell)] = k;
    }
    std::vector<std::size_t> partners;
    for (const GridPore& pore : pores) {
        std::map<std::size_t, std::size_t> shared;
        for (const GridCell cell : pore.cells) {
            if (owner[place(cell)] != nobody) ++shared[owner[place(cell)]];
        }
        const auto best = std::ranges::max_element(shared, {}, [](const auto& entry) { return entry.second; });
        partners.push_back(best == shared.end() ? nobody : best->first);
    }
    return partners;
}

}  // namespace

PoreErrors chamber_errors(const std::vector<Circle>& exact, const std::vector<Circle>& pixels, double period,
                          double reach) {
    std::vector<char> exact_taken(exact.size(), 0), pixel_taken(pixels.size(), 0);
    std::vector<double> differences;
    for (const Pair& pair : near_pairs(exact, pixels, period, reach)) {
        if (exact_taken[pair.exact] || pixel_taken[pair.pixel]) continue;
        exact_taken[pair.exact] = pixel_taken[pair.pixel] = 1;
        differences.push_back(2 * (pixels[pair.pixel].radius - exact[pair.exact].radius));
    }
    return summary(differences, exact.size(), pixels.size());
}

PoreErrors density_pore_errors(const Map& exact, const Map& voxels, double threshold, double cell_area) {
    if (exact.values.size() != voxels.values.size()) throw std::invalid_argument("maps of different size compared");
    const std::vector<GridPore> pores = grid_pores(exact, threshold, GridConnectivity::sides_and_corners);
    const std::vector<GridPore> others = grid_pores(voxels, threshold, GridConnectivity::sides_and_corners);
    const std::vector<std::size_t> partner = best_partners(pores, others, exact);
    const std::vector<std::size_t> partner_back = best_partners(others, pores, exact);
    const auto diameter = [&](const GridPore& pore) {
        return std::sqrt(4 * cell_area * static_cast<double>(pore.cells.size()) / std::numbers::pi);
    };
    std::vector<double> differences;
    for (std::size_t k = 0; k < pores.size(); ++k) {
        if (partner[k] == nobody || partner_back[partner[k]] != k) continue;
        differences.push_back(diameter(others[partner[k]]) - diameter(pores[k]));
    }
    return summary(differences, pores.size(), others.size());
}

}  // namespace recoat
