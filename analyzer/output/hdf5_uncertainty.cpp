#include "analyzer/output/hdf5_uncertainty.hpp"

#include <sstream>

namespace recoat {
namespace {

void write(const DescribedGroup& group, const Estimate& estimate) {
    const std::string& unit = estimate.quantity.unit;
    std::vector<double> lower, upper, error;
    for (const Interval& interval : estimate.interval) {
        lower.push_back(interval.lower);
        upper.push_back(interval.upper);
        error.push_back(interval.standard_error);
    }
    group.column("value", unit, "of the layer itself", estimate.value);
    group.column("lower", unit, "lower end of the central 95 % of the resamples; NaN: undefined", lower);
    group.column("upper", unit, "upper end of the central 95 % of the resamples; NaN: undefined", upper);
    group.column("standard_error", unit, "standard deviation of the resamples; NaN: undefined", error);
    if (estimate.quantity.is_list) {
        group.column("items", "1", "coordination number, edge of a bin or smallest size of a class of each value",
                     estimate.quantity.items);
    }
}

}  // namespace

void write_uncertainty(const hdf5::Group& group, const Uncertainty& uncertainty) {
    group.set_attribute("method", "circular block bootstrap along x");
    group.set_attribute("level", interval_level);
    group.set_attribute("block", uncertainty.block_length);
    group.set_attribute("block_columns", std::int64_t{uncertainty.bootstrap.block});
    group.set_attribute("resamples", static_cast<std::int64_t>(uncertainty.bootstrap.resamples));
    group.set_attribute("seed", static_cast<std::int64_t>(uncertainty.bootstrap.seed));
    for (const Estimate& estimate : uncertainty.estimates) {
        std::istringstream path(estimate.quantity.group + "/" + estimate.quantity.name);
        const hdf5::Group* above = &group;
        std::vector<hdf5::Group> opened;
        opened.reserve(8);
        for (std::string part; std::getline(path, part, '/');) {
            opened.push_back(above->has(part) ? above->group(part) : above->create_group(part));
            above = &opened.back();
        }
        write(DescribedGroup(std::move(opened.back())), estimate);
    }
}

}  // namespace recoat
