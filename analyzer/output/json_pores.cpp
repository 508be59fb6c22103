#include "analyzer/output/json_pores.hpp"

#include <numbers>

namespace recoat {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const DensityPore& pore) {
    Json json = {{"cells", pore.cells},
                 {"diameter", pore.diameter},
                 {"percolates", pore.percolates},
                 {"touches_x_edge", pore.touches_x_edge},
                 {"x", pore.x},
                 {"y", pore.y}};
    if (!pore.shape) return json;
    const PixelShape& shape = *pore.shape;
    json["angle"] = shape.angle ? Json(*shape.angle) : Json(nullptr);
    json["elongation"] = shape.elongation;
    json["hull_area"] = shape.hull_area;
    json["hull_perimeter"] = shape.hull_perimeter;
    json["min_rect"] = {shape.rect_long, shape.rect_short};
    json["bbox"] = {shape.extent_x, shape.extent_y};
    json["solidity"] = pore.area / shape.hull_area;
    json["rectangularity"] = pore.area / (shape.rect_long * shape.rect_short);
    json["rect_aspect"] = shape.rect_long / shape.rect_short;
    json["circularity"] = 4 * std::numbers::pi * pore.area / (shape.hull_perimeter * shape.hull_perimeter);
    return json;
}

/// Rows of x, y, diameter and, where it is measured, persistence.
Json rows(const ChamberPores& pores) {
    Json json = Json::array();
    for (std::size_t i = 0; i < pores.circles.size(); ++i) {
        const Circle& circle = pores.circles[i];
        Json row = {circle.x, circle.y, 2 * circle.radius};
        if (!pores.persistence.empty()) row.push_back(pores.persistence[i]);
        json.push_back(row);
    }
    return json;
}

}  // namespace

Json json_pore_sizes(const PoreSizes& sizes) {
    return {{"count", sizes.count},
            {"mean", sizes.mean},
            {"median", sizes.median},
            {"max", sizes.max},
            {"group_number_fraction", sizes.group_number_fraction},
            {"group_area_fraction", sizes.group_area_fraction},
            {"sorted_sizes", sizes.sorted}};
}

Json json_density_pores(const std::vector<DensityPoreMetrics>& all) {
    Json result = Json::object();
    for (const DensityPoreMetrics& metrics : all) {
        Json json = json_pore_sizes(metrics.sizes);
        json["area_fraction"] = metrics.area_fraction;
        json["angle_number_counts"] = metrics.angle_number_counts;
        json["angle_cell_counts"] = metrics.angle_cell_counts;
        json["pores"] = Json::array();
        for (const DensityPore& pore : metrics.pores) json["pores"].push_back(to_json(pore));
        result[std::to_string(static_cast<int>(metrics.connectivity))] = json;
    }
    return result;
}

Json json_chamber_pores(const ChamberPoreMetrics& metrics) {
    Json all = json_pore_sizes(metrics.all.sizes), separate = json_pore_sizes(metrics.separate.sizes);
    separate["n_beyond_data"] = metrics.n_beyond_data;
    separate["circles_x_y_d"] = rows(metrics.separate);
    Json json = {{"L", all}, {"A", separate}, {"B", json_pore_sizes(metrics.disjoint.sizes)}};
    if (metrics.persistent) {
        json["P"] = json_pore_sizes(metrics.persistent->sizes);
        json["P"]["circles_x_y_d_persistence"] = rows(*metrics.persistent);
    }
    return json;
}

}  // namespace recoat
