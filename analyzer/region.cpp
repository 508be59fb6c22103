#include "analyzer/region.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "analyzer/division.hpp"

namespace recoat {
namespace {

/// Windows that a region may reach beyond the particles: an edge that has lost its powder is still measured, a region
/// in the wrong unit of length is not.
constexpr double windows_beyond = 5;

Region of_particles(const Config& config, const SourceInfo& info, const RegionScale& scale) {
    const double length = info.x_upper - info.x_lower - 2 * scale.diameter;
    const double cells = std::floor(length / scale.cell + fits_within);
    if (!(cells >= 1)) {
        config.fail("x_range", fmt::format("the particles lie between x = {:.6g} and {:.6g} m, too near for a region "
                                           "to be found; give one (--region)",
                                           info.x_lower, info.x_upper));
    }
    const double begin = info.x_lower + scale.diameter;
    return {begin, begin + cells * scale.cell};
}

Region of_blade(const Config& config, const SourceInfo& info, const RegionScale& scale) {
    constexpr double paper_start = 100.0 / 500, paper_end = 10.0 / 500;
    const double start =
        config.quantity_or("skip_start", Dimension::length, paper_start * info.spread_length, Range::not_negative());
    const double end =
        config.quantity_or("skip_end", Dimension::length, paper_end * info.spread_length, Range::not_negative());
    const double cells = std::floor((info.spread_length - start - end) / scale.cell + fits_within);
    if (cells < 1)
        config.fail(config.has("skip_start") ? "skip_start" : "skip_end",
                    "nothing is left of the spreading length; skip less, or give x_range");
    const double begin = info.blade_start + start;
    return {begin, begin + cells * scale.cell};
}

Region given(const Config& config) {
    for (const std::string_view key : {"skip_start", "skip_end"}) {
        if (config.has(key))
            config.fail(key, "x_range is given too; give either x_range or what to skip of the spreading length");
    }
    const std::vector<double> range = config.quantities("x_range", Dimension::length, 2);
    const Region region = {range[0], range[1]};
    if (!(region.end > region.begin))
        config.fail("x_range", "the region ends before it begins; give [start, end] with start < end");
    return region;
}

}  // namespace

Region read_region(const Config& config, const SourceInfo& info, const RegionScale& scale) {
    if (config.has("x_range")) return given(config);
    if (!std::isnan(info.blade_start) && !std::isnan(info.spread_length)) return of_blade(config, info, scale);
    if (std::isnan(info.x_lower)) (void)config.quantities("x_range", Dimension::length, 2);  // says that it is missing
    return of_particles(config, info, scale);
}

void check_reach(const Config& config, const SourceInfo& info, const Region& region, double window) {
    if (std::isnan(info.x_lower) || !config.has("x_range")) return;
    const double way_end = info.blade_start + info.spread_length;  // NaN where it is not known
    const double low = std::fmin(info.x_lower, info.blade_start), high = std::fmax(info.x_upper, way_end);
    const double beyond = std::max(low - region.begin, region.end - high), most = windows_beyond * window;
    const bool apart = region.end <= low || region.begin > high;
    if (apart) {
        config.fail("x_range", fmt::format("no particle lies in the region x = {:.9g} ... {:.9g} m; they lie between x "
                                           "= {:.9g} and {:.9g} m: give a region there",
                                           region.begin, region.end, info.x_lower, info.x_upper));
    }
    if (beyond > most) {
        config.fail("x_range", fmt::format("the region x = {:.9g} ... {:.9g} m reaches {:.3g} m beyond the particles, "
                                           "which lie between x = {:.9g} and {:.9g} m; give one that reaches no more "
                                           "than {:.3g} m beyond them",
                                           region.begin, region.end, beyond, info.x_lower, info.x_upper, most));
    }
}

}  // namespace recoat
