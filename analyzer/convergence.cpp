#include "analyzer/convergence.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace recoat {
namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

constexpr double smallest_chamber = 0.5;  ///< [d_p]; below are the holes between touching particles

std::vector<double> chambers_of(const std::vector<double>& diameters) {
    std::vector<double> chosen;
    std::ranges::copy_if(diameters, std::back_inserter(chosen), [](double d) { return d >= smallest_chamber; });
    return chosen;
}

double median_of(const std::vector<double>& sorted) { return sorted.empty() ? 0 : quantile(sorted, 0.5); }

/// Collects the quantities of a convergence study.
class Study {
public:
    Study(const Analysis& analysis, Convergence& result) : analysis_(analysis), result_(result) {}

    /// The share that errors are compared by is that of `scale`, or of the exact value.
    void add(std::string name, std::string unit, double exact, const std::function<double(const VoxelMetrics&)>& voxel,
             std::optional<double> scale = {}) {
        if (std::isnan(exact)) return;
        ConvergenceQuantity quantity;
        quantity.name = std::move(name);
        quantity.unit = std::move(unit);
        quantity.exact = exact;
        for (const VoxelMetrics& metrics : analysis_.voxel) quantity.voxel.push_back(voxel(metrics));
        judge(quantity, result_.voxels_per_dp, result_.tolerance, scale.value_or(exact));
        result_.quantities.push_back(std::move(quantity));
    }

private:
    const Analysis& analysis_;
    Convergence& result_;
};

void add_maps(Study& study, const Analysis& analysis) {
    const BoxStats& phi = analysis.phi_exact;
    study.add("packing density, median", "", phi.median, [](const VoxelMetrics& v) { return v.phi.median; });
    study.add("packing density, IQR/median", "", phi.iqr_over_median.value_or(undefined),
              [](const VoxelMetrics& v) { return v.phi.iqr_over_median.value_or(undefined); });
    study.add(
        "packing density, rms of nodes", "", 0, [](const VoxelMetrics& v) { return v.phi_error.rms; }, phi.mean);
    study.add("height, mean", "d_p", analysis.height.mean, [](const VoxelMetrics& v) { return v.height.mean; });
    study.add("roughness Ra", "d_p", analysis.height.roughness,
              [](const VoxelMetrics& v) { return v.height.roughness; });
    study.add("empty nodes, share", "", analysis.height.empty_fraction,
              [](const VoxelMetrics& v) { return v.height.empty_fraction; });
}

void add_pores(Study& study, const Analysis& analysis) {
    const DensityPoreMetrics& pores = analysis.density_pores.back();
    const auto nodes = static_cast<double>(analysis.packing.exact.values.size());
    study.add("density pores (8), number", "", static_cast<double>(pores.sizes.count),
              [](const VoxelMetrics& v) { return static_cast<double>(v.density_pore_cells.size()); });
    study.add("density pores, share of area", "", pores.area_fraction, [nodes](const VoxelMetrics& v) {
        double cells = 0;
        for (const std::size_t count : v.density_pore_cells) cells += static_cast<double>(count);
        return nodes > 0 ? cells / nodes : 0;
    });
    if (!analysis.chamber_pores.persistent) return;
    const std::vector<double> exact = chambers_of(analysis.chamber_pores.persistent->sizes.sorted);
    study.add("chamber pores (P, >= 0.5 d_p)", "", static_cast<double>(exact.size()),
              [](const VoxelMetrics& v) { return static_cast<double>(chambers_of(v.chambers.sizes.sorted).size()); });
    // The number alone may be right by as many misses as false ones.
    const auto count = static_cast<double>(exact.size());
    const auto errors_of = [](const VoxelMetrics& v) { return v.chamber_errors.value_or(PoreErrors{}); };
    study.add(
        "  missed", "", 0, [=](const VoxelMetrics& v) { return static_cast<double>(errors_of(v).missed); }, count);
    study.add(
        "  spurious", "", 0, [=](const VoxelMetrics& v) { return static_cast<double>(errors_of(v).spurious); }, count);
    study.add("chamber median diameter", "d_p", median_of(exact),
              [](const VoxelMetrics& v) { return median_of(chambers_of(v.chambers.sizes.sorted)); });
}

/// Slope of log |error| against -log n.
std::optional<double> order_of(const ConvergenceQuantity& quantity, const std::vector<int>& voxels_per_dp) {
    double count = 0, x_sum = 0, y_sum = 0, xx = 0, xy = 0;
    for (std::size_t k = 0; k < voxels_per_dp.size(); ++k) {
        const double error = std::abs(quantity.error(k));
        if (!(error > 0) || !std::isfinite(error)) continue;
        const double x = -std::log(voxels_per_dp[k]), y = std::log(error);
        count += 1;
        x_sum += x;
        y_sum += y;
        xx += x * x;
        xy += x * y;
    }
    if (count < 2) return {};
    return (count * xy - x_sum * y_sum) / (count * xx - x_sum * x_sum);
}

}  // namespace

void judge(ConvergenceQuantity& quantity, const std::vector<int>& voxels_per_dp, double tolerance, double scale) {
    const double allowed = tolerance * (scale != 0 ? std::abs(scale) : 1);
    quantity.order = order_of(quantity, voxels_per_dp);
    for (std::size_t k = voxels_per_dp.size(); k > 0; --k) {
        if (!(std::abs(quantity.error(k - 1)) <= allowed)) break;
        quantity.enough = voxels_per_dp[k - 1];
    }
    if (quantity.enough || voxels_per_dp.empty() || !quantity.order || *quantity.order <= 0 || allowed <= 0) return;
    const double last = std::abs(quantity.error(voxels_per_dp.size() - 1));
    quantity.projected = voxels_per_dp.back() * std::pow(last / allowed, 1 / *quantity.order);
}

std::optional<int> Convergence::enough() const {
    std::optional<int> largest;
    for (const ConvergenceQuantity& quantity : quantities) {
        if (!quantity.enough) return {};
        largest = std::max(largest.value_or(0), *quantity.enough);
    }
    return largest;
}

Convergence convergence(const Analysis& analysis, double tolerance) {
    Convergence result;
    result.tolerance = tolerance;
    for (const VoxelMetrics& metrics : analysis.voxel) result.voxels_per_dp.push_back(metrics.voxels_per_dp);
    Study study(analysis, result);
    add_maps(study, analysis);
    add_pores(study, analysis);
    return result;
}

}  // namespace recoat
