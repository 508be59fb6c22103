#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "analyzer/fields/sphere_box.hpp"
#include "analyzer/uncertainty/column_sample.hpp"
#include "analyzer/uncertainty/estimator.hpp"

namespace recoat {
namespace {

ColumnSample sample_of(const Map& map, int columns, double above) {
    std::vector<ColumnSample::Item> items;
    for (int ix = 0; ix < map.nx; ++ix) {
        for (int iy = 0; iy < map.ny; ++iy) {
            if (map.at(ix, iy) > above) items.push_back({map.at(ix, iy), static_cast<std::uint32_t>(map.first_x + ix)});
        }
    }
    return {std::move(items), columns};
}

constexpr double all_values = -std::numeric_limits<double>::infinity();

Estimator packing_estimator(const std::string& group, const Map& phi, int columns) {
    const auto sample = std::make_shared<ColumnSample>(sample_of(phi, columns, all_values));
    Estimator result;
    for (const char* name : {"mean", "median", "q1", "q3", "iqr", "iqr_over_median"})
        result.quantities.push_back({group, name, "1"});
    result.evaluate = [sample](const ColumnWeights& weights, std::vector<double>& numbers) {
        constexpr std::array shares = {0.25, 0.5, 0.75};
        const std::vector<double> quartiles = sample->quantiles(weights, shares);
        const double iqr = quartiles[2] - quartiles[0], median = quartiles[1];
        const double relative = median != 0 ? iqr / median : std::numeric_limits<double>::quiet_NaN();
        for (const double number : {sample->mean(weights), median, quartiles[0], quartiles[2], iqr, relative})
            numbers.push_back(number);
    };
    return result;
}

Estimator height_estimator(const Analysis& analysis) {
    const int columns = analysis.layer.grid.nx;
    const auto all = std::make_shared<ColumnSample>(sample_of(analysis.height_map, columns, all_values));
    const auto nonempty = std::make_shared<ColumnSample>(sample_of(analysis.height_map, columns, 0));
    Estimator result;
    for (const auto& [name, unit] : {std::pair("mean", "d_p"), std::pair("Ra", "d_p"), std::pair("Ra_nonempty", "d_p"),
                                     std::pair("empty_fraction", "1")})
        result.quantities.push_back({"height", name, unit});
    result.evaluate = [all, nonempty](const ColumnWeights& weights, std::vector<double>& numbers) {
        numbers.push_back(all->mean(weights));
        numbers.push_back(all->mean_deviation(weights));
        numbers.push_back(nonempty->mean_deviation(weights));
        const double nodes = all->count(weights);
        numbers.push_back((nodes - nonempty->count(weights)) / nodes);
    };
    return result;
}

Estimator height_fraction_estimator(const Analysis& analysis, const AnalysisConfig& config) {
    const std::vector<double>& edges = analysis.height.bin_upper_edges;
    const auto table = std::make_shared<ColumnTable>(analysis.layer.grid.nx, edges.size() + 1);
    const Map& map = analysis.height_map;
    for (int ix = 0; ix < map.nx; ++ix) {
        for (int iy = 0; iy < map.ny; ++iy) {
            const double h = map.at(ix, iy);
            const double k = h > 0 ? std::max(std::ceil(h / config.height_bin - config.bin_tol), 1.0) : 0;
            table->add(map.first_x + ix, static_cast<std::size_t>(k));
        }
    }
    Estimator result;
    result.quantities.push_back({"height", "fraction", "1", true, edges});
    const double nodes = static_cast<double>(map.values.size());
    result.evaluate = [table, nodes](const ColumnWeights& weights, std::vector<double>& numbers) {
        const std::vector<double> sums = table->sums(weights);
        for (std::size_t k = 1; k < sums.size(); ++k) numbers.push_back(sums[k] / nodes);
    };
    return result;
}

Estimator totals_estimator(const Analysis& analysis, const AnalysisConfig& config) {
    const Layer& layer = analysis.layer;
    const Grid& grid = layer.grid;
    const auto volume = std::make_shared<ColumnTable>(grid.nx, 2);  // whole spheres and what lies in the column [d_p^3]
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const double side = grid.cell().x;
    for (std::size_t i = 0; i < layer.size(); ++i) {
        const double x = layer.x[i], r = layer.radius[i];
        if (layer.in_region[i]) volume->add(column_of(x, grid, config.bin_tol), 0, sphere_volume(r));
        const int first = std::max(static_cast<int>(std::floor((x - r) / side)), 0);
        const int last = std::min(static_cast<int>(std::floor((x + r) / side)), grid.nx - 1);
        for (int column = first; column <= last; ++column) {
            volume->add(column, 1,
                        sphere_box_volume({x, 0, 0}, r, {column * side, -infinite, -infinite},
                                          {(column + 1) * side, infinite, infinite}));
        }
    }
    Estimator result;
    result.quantities = {{"totals", "mass_per_area", "kg/m2"},
                         {"totals", "mass_per_area_clipped", "kg/m2"},
                         {"totals", "layer_phi", "1"}};
    const double area = layer.length * layer.width, clearance = layer.clearance;
    const double mass = config.density * config.particle_diameter;
    result.evaluate = [=](const ColumnWeights& weights, std::vector<double>& numbers) {
        const std::vector<double> sums = volume->sums(weights);
        numbers.push_back(mass * sums[0] / area);
        numbers.push_back(mass * sums[1] / area);
        numbers.push_back(sums[1] / (area * clearance));
    };
    return result;
}

}  // namespace

std::size_t column_of(double x, const Grid& grid, double tolerance) {
    const double column = std::floor(x / grid.cell().x + tolerance);
    return static_cast<std::size_t>(std::clamp(column, 0.0, static_cast<double>(grid.nx - 1)));
}

std::vector<Estimator> surface_estimators(const Analysis& analysis, const AnalysisConfig& config) {
    const int columns = analysis.layer.grid.nx;
    return {packing_estimator("phi_exact", analysis.packing.exact, columns),
            packing_estimator("phi_centre", analysis.packing.centre, columns), height_estimator(analysis),
            height_fraction_estimator(analysis, config), totals_estimator(analysis, config)};
}

}  // namespace recoat
