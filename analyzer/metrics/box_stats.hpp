#pragma once

#include <optional>
#include <span>
#include <vector>

namespace recoat {

/// What a box plot shows of some values, and their mean. All 0 for no values.
struct BoxStats {
    std::size_t n = 0;
    double mean = 0, median = 0, q1 = 0, q3 = 0, iqr = 0;
    std::optional<double> iqr_over_median;  ///< none where the median is 0
    double whisker_lo = 0, whisker_hi = 0;  ///< extreme values within 1.5 IQR of the quartiles (Tukey)
    std::size_t n_outliers = 0;             ///< values beyond the whiskers
    double min = 0, max = 0;
};

[[nodiscard]] BoxStats box_stats(std::span<const double> values);

/// Quantile of type 7: linear between the order statistics, at share x (n - 1). `sorted` ascends and is not empty.
[[nodiscard]] double quantile(std::span<const double> sorted, double share);

/// Sum of the values over their number; 0 for none.
[[nodiscard]] double mean(std::span<const double> values);

}  // namespace recoat
