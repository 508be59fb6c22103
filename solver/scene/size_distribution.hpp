#pragma once

#include <functional>
#include <vector>

namespace recoat {

/// What a share of a size distribution is a share of.
enum class Weighting { number, mass };

/// Diameters of spheres of one density between two bounds: as many as one likes, by a share in [0, 1] of their number.
///
/// Kept as shares of fine classes in which the cumulative distribution is a straight line: 4096 between the bounds
/// (equal ratios for log-normal), or 64 to each class of a table. A distribution by mass becomes one by number with
/// 1/d^3 [docs/physics.md section 6].
class SizeDistribution {
public:
    /// Normal in the diameter, cut at the bounds [m].
    static SizeDistribution normal(double mean, double deviation, double smallest, double largest, Weighting weighting);
    /// Normal in its logarithm; `deviation` is the geometric standard deviation, above 1 [-].
    static SizeDistribution log_normal(double median, double deviation, double smallest, double largest,
                                       Weighting weighting);
    /// `cumulative[k]` is the share finer than `diameters[k]`, both rising, from 0 to 1; straight lines in between.
    static SizeDistribution table(const std::vector<double>& diameters, const std::vector<double>& cumulative,
                                  Weighting weighting);

    /// Diameter below which the share `share` of the number lies [m].
    [[nodiscard]] double diameter(double share) const;
    /// Diameter below which the share `share` of the mass lies [m].
    [[nodiscard]] double diameter_by_mass(double share) const;
    /// Share of the number that is finer than `diameter` [-].
    [[nodiscard]] double finer(double diameter) const;
    /// Mean of d^power over the number [m^power].
    [[nodiscard]] double moment(int power) const;
    [[nodiscard]] double smallest() const { return edges_.front(); }
    [[nodiscard]] double largest() const { return edges_.back(); }

    friend bool operator==(const SizeDistribution&, const SizeDistribution&) = default;

private:
    /// From the cumulative distribution at `edges`, by number or mass; it need not run from 0 to 1.
    SizeDistribution(std::vector<double> edges, const std::function<double(double)>& cumulative, Weighting weighting);

    std::vector<double> edges_;       ///< of the classes, rising [m]
    std::vector<double> cumulative_;  ///< share of the number below each edge, from 0 to 1
};

}  // namespace recoat
