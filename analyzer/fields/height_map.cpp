#include "analyzer/fields/height_map.hpp"

#include <algorithm>
#include <cmath>

#include "analyzer/fields/parallel.hpp"
#include "analyzer/fields/row_lists.hpp"
#include "analyzer/fields/sphere_box.hpp"

namespace recoat {
namespace {

/// A sphere that touches a square by less than this has no height over it: squared half chord [d_p^2].
constexpr double smallest_square = 1e-9;

/// Nodes whose square may come within `reach` of `position`.
RowRange nodes_near(double position, double reach, double spacing) {
    return {static_cast<int>(std::ceil((position - reach) / spacing - 0.5)),
            static_cast<int>(std::floor((position + reach) / spacing - 0.5))};
}

}  // namespace

Map height_map(const Layer& layer, const AnalysisConfig& config) {
    const Grid& grid = layer.grid;
    const Sides half = grid.stretched(0.5 * config.height_window), cell = grid.cell();
    std::vector<RowRange> rows(layer.size());
    for (std::size_t p = 0; p < layer.size(); ++p) {
        const RowRange near = nodes_near(layer.x[p], layer.radius[p] + half.x, cell.x);
        rows[p] = {std::max(near.first, 0), std::min(near.last, grid.nx - 1)};
    }
    const RowLists lists(rows, grid.nx);
    Map map(0, grid.nx, grid.ny);
    for_each_in_parallel(grid.nx, [&](int ix) {
        const double node_x = grid.node_x(ix);
        for (const std::size_t p : lists.items(ix)) {
            const double r = layer.radius[p], y = layer.y[p];
            const double rest = r * r - squared_distance_to_interval(layer.x[p], node_x - half.x, node_x + half.x);
            if (rest <= smallest_square) continue;
            const RowRange near = nodes_near(y, r + half.y, cell.y);
            for (int iy = near.first; iy <= near.last; ++iy) {
                const double node_y = grid.node_y(iy);
                const double square = rest - squared_distance_to_interval(y, node_y - half.y, node_y + half.y);
                if (square <= smallest_square) continue;
                double& height = map.at(ix, ((iy % grid.ny) + grid.ny) % grid.ny);
                height = std::max(height, layer.z[p] + std::sqrt(square));
            }
        }
    });
    return map;
}

}  // namespace recoat
