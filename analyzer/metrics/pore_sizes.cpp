#include "analyzer/metrics/pore_sizes.hpp"

#include <algorithm>
#include <functional>

#include "analyzer/fields/sort_in_pieces.hpp"
#include "analyzer/metrics/box_stats.hpp"

namespace recoat {

std::size_t pore_size_group(double diameter, double tolerance) {
    return static_cast<std::size_t>(std::min(diameter + tolerance, static_cast<double>(PoreSizes::groups - 1)));
}

PoreSizes pore_sizes(std::vector<double> diameters, double tolerance) {
    PoreSizes sizes;
    sort_in_pieces(diameters, std::identity{}, std::less<>{});
    sizes.sorted = std::move(diameters);
    sizes.count = sizes.sorted.size();
    if (sizes.count == 0) return sizes;
    sizes.mean = mean(sizes.sorted);
    sizes.median = quantile(sizes.sorted, 0.5);
    sizes.max = sizes.sorted.back();
    double area = 0;
    for (const double diameter : sizes.sorted) {
        const std::size_t group = pore_size_group(diameter, tolerance);
        sizes.group_number_fraction[group] += 1;
        sizes.group_area_fraction[group] += diameter * diameter;
        area += diameter * diameter;
    }
    for (double& share : sizes.group_number_fraction) share /= static_cast<double>(sizes.count);
    for (double& share : sizes.group_area_fraction) share /= area;
    return sizes;
}

}  // namespace recoat
