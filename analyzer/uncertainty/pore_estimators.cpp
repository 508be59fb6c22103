#include <algorithm>
#include <array>
#include <memory>
#include <numeric>

#include "analyzer/uncertainty/column_sample.hpp"
#include "analyzer/uncertainty/estimator.hpp"

namespace recoat {
namespace {

/// Fewer pores tell nothing about the scatter of their sizes: resamples only repeat them.
constexpr std::size_t fewest_pores = 5;

/// A pore by its place along x and its diameter [d_p].
struct Place {
    double x, diameter;
};

/// Sizes of pores, each of which belongs to the column of its place.
Estimator size_estimator(const std::string& group, const std::vector<Place>& pores, const Analysis& analysis,
                         double tolerance) {
    constexpr std::size_t groups = PoreSizes::groups;
    const Grid& grid = analysis.layer.grid;
    const auto number = std::make_shared<ColumnTable>(grid.nx, groups),
               area = std::make_shared<ColumnTable>(grid.nx, groups);
    std::vector<ColumnSample::Item> items;
    for (const auto& [x, diameter] : pores) {
        const std::size_t column = column_of(x, grid, tolerance);
        const std::size_t k = pore_size_group(diameter, tolerance);
        number->add(column, k);
        area->add(column, k, diameter * diameter);
        items.push_back({diameter, static_cast<std::uint32_t>(column)});
    }
    const auto sample = std::make_shared<ColumnSample>(std::move(items), grid.nx);
    std::vector<double> lower_edges(groups);
    std::iota(lower_edges.begin(), lower_edges.end(), 0.0);
    Estimator result;
    result.quantities = {{group, "count", "1"},
                         {group, "mean", "d_p"},
                         {group, "median", "d_p"},
                         {group, "group_number_fraction", "1", true, lower_edges},
                         {group, "group_area_fraction", "1", true, lower_edges}};
    for (std::size_t k = 1; k < result.quantities.size(); ++k)
        result.quantities[k].has_interval = pores.size() >= fewest_pores;
    result.evaluate = [=](const ColumnWeights& weights, std::vector<double>& numbers) {
        constexpr std::array half = {0.5};
        numbers.push_back(sample->count(weights));
        numbers.push_back(sample->mean(weights));
        numbers.push_back(sample->quantiles(weights, half)[0]);
        for (const auto& table : {number, area}) {
            const std::vector<double> sums = table->sums(weights);
            const double all = std::accumulate(sums.begin(), sums.end(), 0.0);
            for (const double sum : sums) numbers.push_back(sum / all);
        }
    };
    return result;
}

/// Share of the cells that belong to density pores.
Estimator area_estimator(const std::string& group, const Analysis& analysis, double threshold) {
    const Map& phi = analysis.packing.exact;
    const auto table = std::make_shared<ColumnTable>(analysis.layer.grid.nx, 2);  // all cells, those in pores
    for (int ix = 0; ix < phi.nx; ++ix) {
        for (int iy = 0; iy < phi.ny; ++iy) {
            table->add(phi.first_x + ix, 0);
            if (phi.at(ix, iy) < threshold) table->add(phi.first_x + ix, 1);
        }
    }
    return {{{group, "area_fraction", "1"}}, [table](const ColumnWeights& weights, std::vector<double>& numbers) {
                const std::vector<double> sums = table->sums(weights);
                numbers.push_back(sums[1] / sums[0]);
            }};
}

std::vector<Place> places(const ChamberPores& pores) {
    std::vector<Place> result;
    for (const Circle& circle : pores.circles) result.push_back({circle.x, 2 * circle.radius});
    return result;
}

std::vector<Place> places(const DensityPoreMetrics& metrics) {
    std::vector<Place> result;
    for (const DensityPore& pore : metrics.pores) result.push_back({pore.x, pore.diameter});
    return result;
}

}  // namespace

std::vector<Estimator> pore_estimators(const Analysis& analysis, const AnalysisConfig& config) {
    std::vector<Estimator> result;
    for (const DensityPoreMetrics& metrics : analysis.density_pores) {
        const std::string group = "density_pores/" + std::to_string(static_cast<int>(metrics.connectivity));
        result.push_back(size_estimator(group, places(metrics), analysis, config.bin_tol));
        result.push_back(area_estimator(group, analysis, config.density_threshold));
    }
    const ChamberPoreMetrics& chambers = analysis.chamber_pores;
    for (const auto& [rule, pores] :
         {std::pair("L", &chambers.all), std::pair("A", &chambers.separate), std::pair("B", &chambers.disjoint)}) {
        result.push_back(
            size_estimator(std::string("chamber_pores/") + rule, places(*pores), analysis, config.bin_tol));
    }
    if (chambers.persistent)
        result.push_back(size_estimator("chamber_pores/P", places(*chambers.persistent), analysis, config.bin_tol));
    return result;
}

}  // namespace recoat
