#include "analyzer/output/json_uncertainty.hpp"

#include <cmath>
#include <sstream>

namespace recoat {
namespace {

using Json = nlohmann::ordered_json;

Json or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json to_json(const Estimate& estimate) {
    Json value = Json::array(), lower = Json::array(), upper = Json::array(), error = Json::array();
    for (std::size_t k = 0; k < estimate.value.size(); ++k) {
        value.push_back(or_null(estimate.value[k]));
        lower.push_back(or_null(estimate.interval[k].lower));
        upper.push_back(or_null(estimate.interval[k].upper));
        error.push_back(or_null(estimate.interval[k].standard_error));
    }
    if (!estimate.quantity.is_list)
        return {{"value", value[0]}, {"lower", lower[0]}, {"upper", upper[0]}, {"standard_error", error[0]}};
    return {{"items", estimate.quantity.items},
            {"value", value},
            {"lower", lower},
            {"upper", upper},
            {"standard_error", error}};
}

}  // namespace

Json json_uncertainty(const Uncertainty& uncertainty) {
    Json result = {{"method", "circular block bootstrap along x"},
                   {"level", interval_level},
                   {"block", uncertainty.block_length},
                   {"block_columns", uncertainty.bootstrap.block},
                   {"columns", uncertainty.bootstrap.columns},
                   {"resamples", uncertainty.bootstrap.resamples},
                   {"seed", uncertainty.bootstrap.seed}};
    for (const Estimate& estimate : uncertainty.estimates) {
        Json* place = &result;
        std::istringstream path(estimate.quantity.group);
        for (std::string part; std::getline(path, part, '/');) place = &(*place)[part];
        (*place)[estimate.quantity.name] = to_json(estimate);
    }
    return result;
}

}  // namespace recoat
