#include "analyzer/output/convergence_report.hpp"

#include <cmath>
#include <functional>
#include <span>

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

constexpr std::size_t name_width = 31, exact_width = 9, terminal = 80;

struct Column {
    std::size_t width;
    std::string head;
    std::function<std::string(const ConvergenceQuantity&)> cell;
};

/// One line per quantity: name, exact value and these columns.
std::string rows(const Convergence& convergence, std::span<const Column> columns) {
    std::string text = fmt::format("{:<{}}{:>{}}", "voxel minus exact", name_width, "exact", exact_width);
    for (const Column& column : columns) text += fmt::format("{:>{}}", column.head, column.width);
    for (const ConvergenceQuantity& quantity : convergence.quantities) {
        const std::string what =
            quantity.unit.empty() ? quantity.name : fmt::format("{} [{}]", quantity.name, quantity.unit);
        text += fmt::format("\n{:<{}}{:>{}.4g}", what, name_width, quantity.exact, exact_width);
        for (const Column& column : columns) text += fmt::format("{:>{}}", column.cell(quantity), column.width);
    }
    return text + "\n";
}

Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

}  // namespace

std::string convergence_text(const Convergence& convergence) {
    std::vector<Column> columns;
    for (std::size_t k = 0; k < convergence.voxels_per_dp.size(); ++k) {
        columns.push_back({10, fmt::format("n = {}", convergence.voxels_per_dp[k]),
                           [k](const ConvergenceQuantity& q) { return fmt::format("{:+.1e}", q.error(k)); }});
    }
    columns.push_back({8, "order", [](const ConvergenceQuantity& q) {
                           return q.order ? fmt::format("{:.2f}", *q.order) : std::string("-");
                       }});
    columns.push_back({9, "enough", verdict});
    std::string text;
    for (std::size_t first = 0; first < columns.size();) {
        std::size_t end = first, width = name_width + exact_width;
        while (end < columns.size() && width + columns[end].width <= terminal) width += columns[end++].width;
        text += rows(convergence, std::span(columns).subspan(first, end - first)) + "\n";
        first = end;
    }
    const auto enough = convergence.enough();
    const double share = 100 * convergence.tolerance;
    text += enough ? fmt::format("n = {} keeps every row within {:.3g} % of its exact value\n", *enough, share)
                   : fmt::format(
                         "none of these n keeps every row within {:.3g} % of its exact value;\n"
                         "in brackets: where the order would reach it\n",
                         share);
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
