#include "analyzer/output/map_vti.hpp"

#include <limits>

#include <fmt/format.h>

#include "analyzer/output/pore_cells.hpp"
#include "analyzer/output/vtk_file.hpp"
#include "common/number.hpp"

namespace recoat {
namespace {

/// Values in the order of VTK, x running fastest, over all cells of the grid.
template <class Value>
std::vector<Value> over_grid(const Map& map, const Grid& grid, Value missing, double factor = 1) {
    std::vector<Value> values(grid.size(), missing);
    for (int ix = 0; ix < map.nx; ++ix) {
        for (int iy = 0; iy < map.ny; ++iy) {
            values[static_cast<std::size_t>(iy) * grid.nx + map.first_x + ix] =
                static_cast<Value>(factor * map.at(ix, iy));
        }
    }
    return values;
}

}  // namespace

void write_maps_vti(const std::filesystem::path& place, const Analysis& analysis, const AnalysisConfig& config) {
    const Grid& grid = analysis.layer.grid;
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const double d = config.particle_diameter;
    const Sides cell = grid.cell();
    const std::string extent = fmt::format("0 {} 0 {} 0 0", grid.nx, grid.ny);
    VtkFile file("ImageData", fmt::format("WholeExtent=\"{}\" Origin=\"{} {} {}\" Spacing=\"{} {} {}\"", extent,
                                          shortest(config.x_begin), shortest(config.y_min), shortest(config.base),
                                          shortest(cell.x * d), shortest(cell.y * d), shortest(cell.x * d)));
    file.text(fmt::format("<Piece Extent=\"{}\">\n<CellData Scalars=\"PackingDensity\">\n", extent));
    file.array("PackingDensity", over_grid(analysis.packing.exact, grid, none));
    file.array("PackingDensityCentre", over_grid(analysis.packing.centre, grid, none));
    file.array("Height", over_grid(analysis.height_map, grid, none, d));
    for (const DensityPoreMetrics& pores : analysis.density_pores) {
        file.array(fmt::format("DensityPore{}", static_cast<int>(pores.connectivity)),
                   over_grid(pore_numbers(analysis, config, pores), grid, std::int64_t{0}));
    }
    file.text("</CellData>\n</Piece>\n");
    file.write(place);
}

}  // namespace recoat
