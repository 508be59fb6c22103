#include "analyzer/output/pore_vtp.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "analyzer/output/pore_cells.hpp"
#include "analyzer/output/vtk_file.hpp"

namespace recoat {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr int disc_corners = 64;

/// Adds a polygon whose corners are the last points.
void close_polygon(PolyCells& cells, std::size_t corners) {
    for (std::size_t k = cells.points.size() - corners; k < cells.points.size(); ++k)
        cells.corners.push_back(static_cast<std::int64_t>(k));
    cells.ends.push_back(static_cast<std::int64_t>(cells.corners.size()));
}

/// Rectangle of these sides with this lower corner.
void add_rectangle(PolyCells& cells, Vec3 lower, Sides side) {
    for (const auto& [x, y] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)})
        cells.points.push_back({lower.x + x * side.x, lower.y + y * side.y, lower.z});
    close_polygon(cells, 4);
}

}  // namespace

void write_chambers_vtp(const std::filesystem::path& place, const ChamberPores& pores, const AnalysisConfig& config) {
    const double d = config.particle_diameter;
    PolyCells cells;
    std::vector<double> diameter;
    for (const Circle& circle : pores.circles) {
        for (int k = 0; k < disc_corners; ++k) {
            const double angle = 2 * std::numbers::pi * k / disc_corners;
            cells.points.push_back({config.x_begin + d * (circle.x + circle.radius * std::cos(angle)),
                                    config.y_min + d * (circle.y + circle.radius * std::sin(angle)), config.base});
        }
        close_polygon(cells, disc_corners);
        diameter.push_back(2 * d * circle.radius);
    }
    VtkFile file("PolyData");
    begin_piece(file, cells, true);
    file.text("<CellData Scalars=\"Diameter\">\n");
    file.array("Diameter", diameter);
    file.text("</CellData>\n</Piece>\n");
    file.write(place);
}

void write_density_pores_vtp(const std::filesystem::path& place, const Analysis& analysis, const AnalysisConfig& config,
                             const DensityPoreMetrics& metrics) {
    const Map& phi = analysis.packing.exact;
    const double d = config.particle_diameter;
    const Sides side = analysis.layer.grid.stretched(config.grid * d);
    const std::vector<GridPore> found = pore_cells(analysis, config, metrics);
    PolyCells cells;
    std::vector<std::int64_t> number, size, percolates;
    std::vector<double> diameter, angle, elongation, density;
    for (std::size_t p = 0; p < found.size(); ++p) {
        const DensityPore& pore = metrics.pores[p];
        for (const GridCell cell : found[p].cells) {
            add_rectangle(
                cells,
                {config.x_begin + (phi.first_x + cell.ix) * side.x, config.y_min + cell.iy * side.y, config.base},
                side);
            number.push_back(static_cast<std::int64_t>(p + 1));
            size.push_back(static_cast<std::int64_t>(pore.cells));
            percolates.push_back(pore.percolates);
            diameter.push_back(d * pore.diameter);
            angle.push_back(pore.shape ? pore.shape->angle.value_or(none) : none);
            elongation.push_back(pore.shape ? pore.shape->elongation : none);
            density.push_back(phi.at(cell.ix, ((cell.iy % phi.ny) + phi.ny) % phi.ny));
        }
    }
    VtkFile file("PolyData");
    begin_piece(file, cells, true);
    file.text("<CellData Scalars=\"Angle\">\n");
    file.array("Pore", number);
    file.array("Cells", size);
    file.array("Percolates", percolates);
    file.array("Diameter", diameter);
    file.array("Angle", angle);
    file.array("Elongation", elongation);
    file.array("PackingDensity", density);
    file.text("</CellData>\n</Piece>\n");
    file.write(place);
}

}  // namespace recoat
