#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "analyzer/uncertainty/column_sample.hpp"
#include "analyzer/uncertainty/estimator.hpp"

namespace recoat {
namespace {

constexpr std::size_t no_group = std::numeric_limits<std::size_t>::max();

/// Smallest sizes of the classes of clusters: 1, 2, 3, 4, 5-8, 9-16, 17-32, 33-64, 65 and more.
constexpr std::array<std::size_t, 9> class_begin = {1, 2, 3, 4, 5, 9, 17, 33, 65};

/// Shares of groups of particles in all particles of the region. group_of(particle) is no_group for one in none.
template <class GroupOf>
Estimator share_estimator(const Analysis& analysis, double tolerance, Quantity quantity, GroupOf group_of) {
    const Layer& layer = analysis.layer;
    const std::size_t groups = quantity.size();
    const auto table = std::make_shared<ColumnTable>(layer.grid.nx, groups + 1);  // and all particles
    for (std::size_t i = 0; i < layer.size(); ++i) {
        if (!layer.in_region[i]) continue;
        const std::size_t column = column_of(layer.x[i], layer.grid, tolerance), group = group_of(i);
        table->add(column, groups);
        if (group != no_group) table->add(column, group);
    }
    return {{std::move(quantity)}, [table, groups](const ColumnWeights& weights, std::vector<double>& numbers) {
                const std::vector<double> sums = table->sums(weights);
                for (std::size_t k = 0; k < groups; ++k) numbers.push_back(sums[k] / sums[groups]);
            }};
}

/// Mean of a value over the particles of the region.
template <class Value>
Estimator mean_estimator(const Analysis& analysis, double tolerance, Quantity quantity, Value value) {
    const Layer& layer = analysis.layer;
    const auto table = std::make_shared<ColumnTable>(layer.grid.nx, 2);  // number and sum
    for (std::size_t i = 0; i < layer.size(); ++i) {
        if (!layer.in_region[i]) continue;
        const std::size_t column = column_of(layer.x[i], layer.grid, tolerance);
        table->add(column, 0);
        table->add(column, 1, value(i));
    }
    return {{std::move(quantity)}, [table](const ColumnWeights& weights, std::vector<double>& numbers) {
                const std::vector<double> sums = table->sums(weights);
                numbers.push_back(sums[1] / sums[0]);
            }};
}

Quantity listed(std::string group, std::string name, std::vector<double> items) {
    return {std::move(group), std::move(name), "1", true, std::move(items)};
}

void add_contacts(const Analysis& analysis, double tolerance, std::vector<Estimator>& result) {
    const auto number = [&](std::size_t i) { return analysis.coordination_numbers[i]; };
    result.push_back(mean_estimator(analysis, tolerance, {"clusters", "cn_mean", "1"},
                                    [&](std::size_t i) { return static_cast<double>(number(i)); }));
    std::vector<double> numbers;
    for (std::size_t k = 0; k < analysis.coordination.cn_counts.size(); ++k) numbers.push_back(static_cast<double>(k));
    result.push_back(share_estimator(analysis, tolerance, listed("clusters", "cn_fraction", numbers), number));
}

void add_clusters(const Analysis& analysis, const AnalysisConfig& config, std::vector<Estimator>& result) {
    const auto cluster = [&](std::size_t i) -> const Cluster& {
        return analysis.clusters.cluster[analysis.clusters.of_particle[i]];
    };
    result.push_back(share_estimator(
        analysis, config.bin_tol, listed("clusters", "size_class_fraction", {class_begin.begin(), class_begin.end()}),
        [&](std::size_t i) {
            return static_cast<std::size_t>(std::ranges::upper_bound(class_begin, cluster(i).size) -
                                            class_begin.begin() - 1);
        }));
    const std::vector<double>& edges = analysis.orientation.bin_edges;
    const std::size_t bins = edges.size() - 1;
    for (const OrientationGroup& group : analysis.orientation.groups) {
        const auto bin_of = [&](std::size_t i) {
            const Cluster& mine = cluster(i);
            if (mine.size < 2 || !mine.angle || &analysis.orientation.group_of(mine.size) != &group) return no_group;
            return std::min(static_cast<std::size_t>(*mine.angle / config.angle_bin + config.bin_tol), bins - 1);
        };
        result.push_back(share_estimator(analysis, config.bin_tol,
                                         listed("clusters/orientation/" + std::string(group.name), "fraction_of_all",
                                                {edges.begin(), edges.end() - 1}),
                                         bin_of));
    }
}

void add_vertical(const Analysis& analysis, const AnalysisConfig& config, std::vector<Estimator>& result) {
    const Layer& layer = analysis.layer;
    const double tolerance = config.bin_tol;
    result.push_back(
        mean_estimator(analysis, tolerance, {"vertical", "mean", "d_p"}, [&](std::size_t i) { return layer.z[i]; }));
    result.push_back(mean_estimator(analysis, tolerance, {"vertical", "fraction_above_1dp", "1"},
                                    [&](std::size_t i) { return layer.z[i] > 1 ? 1.0 : 0.0; }));
    result.push_back(
        mean_estimator(analysis, tolerance, {"vertical", "fraction_touching_base", "1"},
                       [&](std::size_t i) { return layer.z[i] - layer.radius[i] < touching_gap ? 1.0 : 0.0; }));
    result.push_back(share_estimator(
        analysis, tolerance, listed("vertical", "fraction", analysis.vertical.bin_centres), [&](std::size_t i) {
            return static_cast<std::size_t>(std::max(std::floor(layer.z[i] / config.z_bin + 0.5 + tolerance), 0.0));
        }));
}

}  // namespace

std::vector<Estimator> particle_estimators(const Analysis& analysis, const AnalysisConfig& config) {
    std::vector<Estimator> result;
    add_contacts(analysis, config.bin_tol, result);
    add_clusters(analysis, config, result);
    add_vertical(analysis, config, result);
    return result;
}

}  // namespace recoat
