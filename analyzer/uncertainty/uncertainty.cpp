#include "analyzer/uncertainty/uncertainty.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analyzer/fields/parallel.hpp"

namespace recoat {
namespace {

constexpr int fewest_blocks = 4;

std::vector<Estimator> all_estimators(const Analysis& analysis, const AnalysisConfig& config) {
    std::vector<Estimator> result = surface_estimators(analysis, config);
    for (const auto& more : {particle_estimators(analysis, config), pore_estimators(analysis, config)})
        result.insert(result.end(), more.begin(), more.end());
    return result;
}

std::vector<double> evaluate(const std::vector<Estimator>& estimators, const ColumnWeights& weights) {
    std::vector<double> numbers;
    for (const Estimator& estimator : estimators) estimator.evaluate(weights, numbers);
    return numbers;
}

}  // namespace

const Estimate& Uncertainty::at(std::string_view group, std::string_view name) const {
    const auto found = std::ranges::find_if(estimates, [&](const Estimate& estimate) {
        return estimate.quantity.group == group && estimate.quantity.name == name;
    });
    if (found == estimates.end()) throw std::out_of_range("no such estimate");
    return *found;
}

Uncertainty bootstrap(const Analysis& analysis, const AnalysisConfig& config) {
    const int columns = analysis.layer.grid.nx;
    const double column = analysis.layer.grid.cell().x;
    Uncertainty result;
    result.bootstrap = {.columns = columns,
                        .block = std::clamp(static_cast<int>(std::lround(config.bootstrap_block / column)), 1,
                                            std::max(columns / fewest_blocks, 1)),
                        .resamples = config.bootstrap_resamples,
                        .seed = config.bootstrap_seed};
    result.block_length = result.bootstrap.block * column;

    const std::vector<Estimator> estimators = all_estimators(analysis, config);
    const std::vector<double> values = evaluate(estimators, ColumnWeights(columns, 1));
    std::vector<std::vector<double>> resampled(values.size(), std::vector<double>(config.bootstrap_resamples));
    for_each_in_parallel(config.bootstrap_resamples, [&](std::size_t b) {
        const std::vector<double> numbers = evaluate(estimators, result.bootstrap.weights(b));
        for (std::size_t k = 0; k < numbers.size(); ++k) resampled[k][b] = numbers[k];
    });
    std::vector<Interval> intervals(values.size());
    for_each_in_parallel(values.size(), [&](std::size_t k) { intervals[k] = interval_of(resampled[k]); });

    std::size_t k = 0;
    for (const Estimator& estimator : estimators) {
        for (const Quantity& quantity : estimator.quantities) {
            Estimate estimate{quantity, {}, {}};
            for (std::size_t item = 0; item < quantity.size(); ++item, ++k) {
                estimate.value.push_back(values[k]);
                estimate.interval.push_back(quantity.has_interval ? intervals[k] : interval_of({}));
            }
            result.estimates.push_back(std::move(estimate));
        }
    }
    return result;
}

}  // namespace recoat
