#include "solver/scene/size_distribution.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace recoat {
namespace {

constexpr int classes = 4096, classes_per_interval = 64;

/// Edges of `count` classes from `lower` to `upper`, without the last.
void add_edges(std::vector<double>& edges, double lower, double upper, int count) {
    for (int k = 0; k < count; ++k) edges.push_back(lower + (upper - lower) * k / count);
}

std::vector<double> edges_between(double lower, double upper) {
    std::vector<double> edges;
    add_edges(edges, lower, upper, classes);
    edges.push_back(upper);
    return edges;
}

double normal_cumulative(double x) { return 0.5 * std::erfc(-x / std::numbers::sqrt2); }

/// Mean of d^power where d is uniform from a to b.
double mean_power(double a, double b, int power) {
    if (power == -1) return std::log(b / a) / (b - a);
    return (std::pow(b, power + 1) - std::pow(a, power + 1)) / ((power + 1) * (b - a));
}

/// Value at `x` of the straight lines through the points (from, to).
double interpolated(const std::vector<double>& from, const std::vector<double>& to, double x) {
    const auto upper = std::clamp(std::ranges::upper_bound(from, x), from.begin() + 1, from.end() - 1);
    const auto k = static_cast<std::size_t>(upper - from.begin());
    const double width = from[k] - from[k - 1];
    const double way = width > 0 ? std::clamp((x - from[k - 1]) / width, 0.0, 1.0) : 0;
    return to[k - 1] + way * (to[k] - to[k - 1]);
}

}  // namespace

SizeDistribution::SizeDistribution(std::vector<double> edges, const std::function<double(double)>& cumulative,
                                   Weighting weighting)
    : edges_(std::move(edges)), cumulative_{0} {
    for (std::size_t k = 0; k + 1 < edges_.size(); ++k) {
        const double a = edges_[k], b = edges_[k + 1];
        const double share = cumulative(b) - cumulative(a);
        cumulative_.push_back(cumulative_.back() + share * (weighting == Weighting::mass ? mean_power(a, b, -3) : 1));
    }
    const double all = cumulative_.back();
    for (double& each : cumulative_) each /= all;
}

SizeDistribution SizeDistribution::normal(double mean, double deviation, double smallest, double largest,
                                          Weighting weighting) {
    return {edges_between(smallest, largest), [=](double d) { return normal_cumulative((d - mean) / deviation); },
            weighting};
}

SizeDistribution SizeDistribution::log_normal(double median, double deviation, double smallest, double largest,
                                              Weighting weighting) {
    std::vector<double> edges = edges_between(std::log(smallest), std::log(largest));
    for (double& edge : edges) edge = std::clamp(std::exp(edge), smallest, largest);
    edges.front() = smallest;
    edges.back() = largest;
    return {edges, [=](double d) { return normal_cumulative(std::log(d / median) / std::log(deviation)); }, weighting};
}

SizeDistribution SizeDistribution::table(const std::vector<double>& diameters, const std::vector<double>& cumulative,
                                         Weighting weighting) {
    std::vector<double> edges;
    for (std::size_t k = 0; k + 1 < diameters.size(); ++k)
        add_edges(edges, diameters[k], diameters[k + 1], classes_per_interval);
    edges.push_back(diameters.back());
    return {edges, [&](double d) { return interpolated(diameters, cumulative, d); }, weighting};
}

double SizeDistribution::diameter(double share) const { return interpolated(cumulative_, edges_, share); }

double SizeDistribution::diameter_by_mass(double share) const {
    std::vector<double> mass{0};
    for (std::size_t k = 0; k + 1 < edges_.size(); ++k)
        mass.push_back(mass.back() + (cumulative_[k + 1] - cumulative_[k]) * mean_power(edges_[k], edges_[k + 1], 3));
    return interpolated(mass, edges_, share * mass.back());
}

double SizeDistribution::finer(double diameter) const { return interpolated(edges_, cumulative_, diameter); }

double SizeDistribution::moment(int power) const {
    double sum = 0;
    for (std::size_t k = 0; k + 1 < edges_.size(); ++k)
        sum += (cumulative_[k + 1] - cumulative_[k]) * mean_power(edges_[k], edges_[k + 1], power);
    return sum;
}

}  // namespace recoat
