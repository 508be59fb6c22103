#include "analyzer/output/csv_tables.hpp"

#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analyzer/output/json_report.hpp"
#include "analyzer/output/pore_cells.hpp"
#include "common/number.hpp"
#include "common/output_file.hpp"

namespace recoat {
namespace {

using Json = nlohmann::ordered_json;
using Rows = std::vector<std::vector<std::string>>;

std::string cell(double value) { return std::isfinite(value) ? shortest(value) : ""; }
std::string cell(std::optional<double> value) { return value ? cell(*value) : ""; }

void write_table(const std::filesystem::path& place, const Rows& rows) {
    std::string text;
    for (const auto& row : rows) text += fmt::format("{}\n", fmt::join(row, ","));
    write_text_file(place, text);
}

/// Parts of the report that are tables of their own, or no results.
const std::set<std::string> other_tables = {"/units", "/config", "/maps", "/particles"};
const std::set<std::string> lists_of_pores = {"sorted_sizes", "pores", "circles_x_y_d", "circles_x_y_d_persistence"};

void collect(const Json& json, const std::string& key, std::vector<std::pair<std::string, std::string>>& values) {
    if (other_tables.contains("/" + key)) return;
    if (json.is_structured()) {
        std::size_t index = 0;
        for (const auto& [name, value] : json.items()) {
            if (lists_of_pores.contains(name)) continue;
            collect(
                value,
                fmt::format("{}{}{}", key, key.empty() ? "" : "/", json.is_array() ? std::to_string(index++) : name),
                values);
        }
    } else if (json.is_number_float()) {
        values.emplace_back(key, cell(json.get<double>()));
    } else {
        values.emplace_back(key, json.is_null() ? "" : json.dump());
    }
}

void write_particles(const std::filesystem::path& place, const Analysis& analysis, const AnalysisConfig& config) {
    const Layer& layer = analysis.layer;
    const double d = config.particle_diameter;
    Rows rows = {
        {"file_index", "x", "y", "z", "radius", "in_region", "cn", "cluster", "cluster_size", "cluster_angle"}};
    for (std::size_t i = 0; i < layer.size(); ++i) {
        const std::size_t cluster = analysis.clusters.of_particle[i];
        rows.push_back({std::to_string(layer.file_index[i]), cell(config.x_begin + d * layer.x[i]),
                        cell(config.y_min + d * layer.y[i]), cell(config.base + d * layer.z[i]),
                        cell(d * layer.radius[i]), std::to_string(layer.in_region[i]),
                        std::to_string(analysis.coordination_numbers[i]), std::to_string(cluster),
                        std::to_string(analysis.clusters.cluster[cluster].size),
                        cell(analysis.clusters.cluster[cluster].angle)});
    }
    write_table(place, rows);
}

void write_maps(const std::filesystem::path& place, const Analysis& analysis, const AnalysisConfig& config) {
    const Map &phi = analysis.packing.exact, &centre = analysis.packing.centre, &height = analysis.height_map;
    const Grid& grid = analysis.layer.grid;
    const double d = config.particle_diameter;
    std::vector<Map> pores;
    Rows rows = {{"x", "y", "phi_exact", "phi_centre", "height"}};
    for (const DensityPoreMetrics& metrics : analysis.density_pores) {
        pores.push_back(pore_numbers(analysis, config, metrics));
        rows[0].push_back(fmt::format("density_pore_{}", static_cast<int>(metrics.connectivity)));
    }
    for (int ix = 0; ix < grid.nx; ++ix) {
        const int row = ix - phi.first_x;
        const bool known = row >= 0 && row < phi.nx;
        for (int iy = 0; iy < grid.ny; ++iy) {
            rows.push_back({cell(config.x_begin + d * grid.node_x(ix)), cell(config.y_min + d * grid.node_y(iy)),
                            known ? cell(phi.at(row, iy)) : "", known ? cell(centre.at(row, iy)) : "",
                            cell(height.at(ix, iy))});
            for (const Map& numbers : pores) rows.back().push_back(known ? cell(numbers.at(row, iy)) : "");
        }
    }
    write_table(place, rows);
}

void write_density_pores(const std::filesystem::path& place, const DensityPoreMetrics& metrics,
                         const AnalysisConfig& config) {
    const double d = config.particle_diameter;
    Rows rows = {{"x", "y", "cells", "diameter", "percolates", "touches_x_edge", "angle", "elongation", "hull_area",
                  "hull_perimeter", "rect_long", "rect_short", "extent_x", "extent_y"}};
    for (const DensityPore& pore : metrics.pores) {
        rows.push_back({cell(config.x_begin + d * pore.x), cell(config.y_min + d * pore.y), std::to_string(pore.cells),
                        cell(pore.diameter), pore.percolates ? "1" : "0", pore.touches_x_edge ? "1" : "0"});
        std::vector<std::string> shape(8);
        if (pore.shape) {
            const PixelShape& s = *pore.shape;
            shape = {cell(s.angle)};
            for (const double value :
                 {s.elongation, s.hull_area, s.hull_perimeter, s.rect_long, s.rect_short, s.extent_x, s.extent_y})
                shape.push_back(cell(value));
        }
        rows.back().insert(rows.back().end(), shape.begin(), shape.end());
    }
    write_table(place, rows);
}

void write_chambers(const std::filesystem::path& place, const ChamberPoreMetrics& metrics,
                    const AnalysisConfig& config) {
    const double d = config.particle_diameter;
    Rows rows = {{"rule", "x", "y", "diameter", "persistence"}};
    const auto add = [&](const char* rule, const ChamberPores& pores) {
        for (std::size_t i = 0; i < pores.circles.size(); ++i) {
            const Circle& circle = pores.circles[i];
            rows.push_back({rule, cell(config.x_begin + d * circle.x), cell(config.y_min + d * circle.y),
                            cell(2 * circle.radius), pores.persistence.empty() ? "" : cell(pores.persistence[i])});
        }
    };
    add("L", metrics.all);
    add("A", metrics.separate);
    add("B", metrics.disjoint);
    if (metrics.persistent) add("P", *metrics.persistent);
    write_table(place, rows);
}

}  // namespace

std::vector<MetricRow> metric_rows(const Analysis& analysis, const AnalysisConfig& config,
                                   const Uncertainty& uncertainty) {
    std::map<std::string, Interval> intervals;
    for (const Estimate& estimate : uncertainty.estimates) {
        const Quantity& quantity = estimate.quantity;
        for (std::size_t k = 0; k < quantity.size(); ++k) {
            const std::string item = quantity.is_list ? fmt::format("/{}", k) : "";
            intervals[quantity.group + "/" + quantity.name + item] = estimate.interval[k];
        }
    }
    std::vector<std::pair<std::string, std::string>> values;
    collect(json_report(analysis, config), "", values);
    std::vector<MetricRow> rows;
    for (const auto& [key, value] : values) {
        rows.push_back({key, value, "", "", ""});
        const auto found = intervals.find(key);
        if (found == intervals.end()) continue;
        rows.back().lower = cell(found->second.lower);
        rows.back().upper = cell(found->second.upper);
        rows.back().standard_error = cell(found->second.standard_error);
    }
    return rows;
}

void write_csv_tables(const std::filesystem::path& folder, const Analysis& analysis, const AnalysisConfig& config,
                      const Uncertainty& uncertainty) {
    Rows rows = {{"key", "value", "lower", "upper", "standard_error"}};
    for (const MetricRow& row : metric_rows(analysis, config, uncertainty))
        rows.push_back({row.key, row.value, row.lower, row.upper, row.standard_error});
    write_table(folder / "metrics.csv", rows);
    write_particles(folder / "particles.csv", analysis, config);
    write_maps(folder / "maps.csv", analysis, config);
    for (const DensityPoreMetrics& metrics : analysis.density_pores) {
        write_density_pores(folder / fmt::format("density_pores_{}.csv", static_cast<int>(metrics.connectivity)),
                            metrics, config);
    }
    write_chambers(folder / "chamber_pores.csv", analysis.chamber_pores, config);
}

}  // namespace recoat
