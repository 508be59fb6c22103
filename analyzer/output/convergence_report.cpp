#include "analyzer/output/convergence_report.hpp"

#include <cmath>

#include <fmt/format.h>

namespace recoat {
namespace {

using Json = nlohmann::ordered_json;

std::string verdict(const ConvergenceQuantity& quantity) {
    if (quantity.enough) return fmt::format("{}", *quantity.enough);
    if (quantity.projected && *quantity.projected < 1e6)
        return fmt::format("(~{:.0f})", std::ceil(*quantity.projected));
    return "none";
}

template <class Value>
Json or_null(const std::optional<Value>& value) {
    return value ? Json(*value) : Json(nullptr);
}

Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

}  // namespace

std::string convergence_text(const Convergence& convergence) {
    std::string text = fmt::format("{:<36}{:>10}", "voxel minus exact", "exact");
    for (const int n : convergence.voxels_per_dp) text += fmt::format("{:>11}", fmt::format("n = {}", n));
    text += fmt::format("{:>8}{:>9}\n", "order", "enough");
    for (const ConvergenceQuantity& quantity : convergence.quantities) {
        const std::string what =
            quantity.unit.empty() ? quantity.name : fmt::format("{} [{}]", quantity.name, quantity.unit);
        text += fmt::format("{:<36}{:>10.5g}", what, quantity.exact);
        for (std::size_t k = 0; k < quantity.voxel.size(); ++k) text += fmt::format("{:>+11.2e}", quantity.error(k));
        text += fmt::format("{:>8}{:>9}\n", quantity.order ? fmt::format("{:.2f}", *quantity.order) : "-",
                            verdict(quantity));
    }
    const std::string aim = fmt::format("errors within {:.3g} % of the exact values", 100 * convergence.tolerance);
    const auto enough = convergence.enough();
    text += enough ? fmt::format("n = {} is enough for {} in every row\n", *enough, aim)
                   : fmt::format(
                         "none of these n is enough for {} in every row; in brackets: where the order would "
                         "reach it\n",
                         aim);
    return text;
}

Json convergence_json(const Convergence& convergence) {
    Json quantities = Json::array();
    for (const ConvergenceQuantity& quantity : convergence.quantities) {
        Json voxel = Json::array(), error = Json::array();
        for (std::size_t k = 0; k < quantity.voxel.size(); ++k) {
            voxel.push_back(finite(quantity.voxel[k]));
            error.push_back(finite(quantity.error(k)));
        }
        quantities.push_back({{"name", quantity.name},
                              {"unit", quantity.unit.empty() ? "1" : quantity.unit},
                              {"exact", finite(quantity.exact)},
                              {"voxel", voxel},
                              {"error", error},
                              {"order", or_null(quantity.order)},
                              {"enough", or_null(quantity.enough)},
                              {"projected", or_null(quantity.projected)}});
    }
    return {{"voxels_per_dp", convergence.voxels_per_dp},
            {"tolerance", convergence.tolerance},
            {"enough", or_null(convergence.enough())},
            {"quantities", quantities}};
}

}  // namespace recoat
