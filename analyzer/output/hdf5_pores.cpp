#include "analyzer/output/hdf5_pores.hpp"

#include <functional>
#include <limits>

namespace recoat {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

void write_shapes(const DescribedGroup& group, const std::vector<DensityPore>& pores) {
    const auto column = [&](const char* name, const char* unit, const char* definition, auto value) {
        std::vector<double> values;
        for (const DensityPore& pore : pores) values.push_back(pore.shape ? value(*pore.shape) : none);
        group.column(name, unit, std::string(definition) + "; NaN: winds round the period", values);
    };
    column("angle", "deg", "angle of the long axis to x, 0 to 90; NaN also where no axis stands out",
           [](const PixelShape& shape) { return shape.angle.value_or(none); });
    column("elongation", "1", "square root of the ratio of the principal second moments",
           std::mem_fn(&PixelShape::elongation));
    column("hull_area", "d_p2", "area of the convex hull of the cells", std::mem_fn(&PixelShape::hull_area));
    column("hull_perimeter", "d_p", "perimeter of that hull", std::mem_fn(&PixelShape::hull_perimeter));
    column("rect_long", "d_p", "long side of the rectangle of the smallest area", std::mem_fn(&PixelShape::rect_long));
    column("rect_short", "d_p", "short side of that rectangle", std::mem_fn(&PixelShape::rect_short));
    column("extent_x", "d_p", "extent along x", std::mem_fn(&PixelShape::extent_x));
    column("extent_y", "d_p", "extent along y, unwrapped", std::mem_fn(&PixelShape::extent_y));
}

void write_pores(const DescribedGroup& group, const std::vector<DensityPore>& pores, const AnalysisConfig& config) {
    const double d = config.particle_diameter;
    std::vector<std::size_t> cells;
    std::vector<int> percolates, edge;
    std::vector<double> x, y, diameter;
    for (const DensityPore& pore : pores) {
        cells.push_back(pore.cells);
        percolates.push_back(pore.percolates);
        edge.push_back(pore.touches_x_edge);
        x.push_back(config.x_begin + d * pore.x);
        y.push_back(config.y_min + d * pore.y);
        diameter.push_back(pore.diameter);
    }
    group.column("cells", "1", "cells of the pore", cells);
    group.column("diameter", "d_p", "diameter of the circle of the same area", diameter);
    group.column("percolates", "1", "1 where the pore winds round the y period", percolates);
    group.column("touches_x_edge", "1", "1 where the pore has a cell in the first or the last row of the map", edge);
    group.column("x", "m", "mean of the cells along x", x);
    group.column("y", "m", "mean of the unwrapped cells along y, in one period from y_min", y);
    write_shapes(group, pores);
}

void write_chambers(const DescribedGroup& group, const ChamberPores& pores, const AnalysisConfig& config) {
    write_pore_sizes(group, pores.sizes);
    const double d = config.particle_diameter;
    std::vector<double> x, y, diameter;
    for (const Circle& circle : pores.circles) {
        x.push_back(config.x_begin + d * circle.x);
        y.push_back(config.y_min + d * circle.y);
        diameter.push_back(2 * circle.radius);
    }
    const DescribedGroup circles = group.group("circles");
    circles.column("x", "m", "centre along x", x);
    circles.column("y", "m", "centre along y, in one period from y_min", y);
    circles.column("diameter", "d_p", "diameter", diameter);
}

}  // namespace

void write_pore_sizes(const DescribedGroup& group, const PoreSizes& sizes) {
    group.value("count", "1", "number of pores", sizes.count);
    group.value("mean", "d_p", "mean diameter", sizes.mean);
    group.value("median", "d_p", "median diameter", sizes.median);
    group.value("max", "d_p", "largest diameter", sizes.max);
    const auto column = [](const auto& array) { return std::vector<double>(array.begin(), array.end()); };
    group.column("group_number_fraction", "1", "share of the pores with a diameter in 0-1, 1-2, 2-3, 3-4, 4-5, 5- d_p",
                 column(sizes.group_number_fraction));
    group.column("group_area_fraction", "1", "the same weighted with the squared diameters",
                 column(sizes.group_area_fraction));
    group.column("sorted_sizes", "d_p", "all diameters, ascending", sizes.sorted);
}

void write_pore_errors(const DescribedGroup& group, const PoreErrors& errors) {
    group.value("matched", "1", "pores of this form with an exact partner", errors.matched);
    group.value("missed", "1", "exact pores without a partner", errors.missed);
    group.value("spurious", "1", "pores of this form without an exact partner", errors.spurious);
    group.value("diameter_bias", "d_p", "mean of diameter minus exact diameter over the matched; NaN: none",
                errors.size ? errors.size->bias : none);
    group.value("diameter_deviation", "d_p", "standard deviation of that difference; NaN: none",
                errors.size ? errors.size->deviation : none);
}

void write_density_pores(const DescribedGroup& group, const DensityPoreMetrics& metrics, const AnalysisConfig& config) {
    write_pore_sizes(group, metrics.sizes);
    group.value("area_fraction", "1", "cells in pores over all cells of the map", metrics.area_fraction);
    group.column("angle_number_counts", "1", "pores per bin of angle_bin of the angle to x",
                 metrics.angle_number_counts);
    group.column("angle_cell_counts", "1", "cells of these pores", metrics.angle_cell_counts);
    write_pores(group.group("pores"), metrics.pores, config);
}

void write_chamber_pores(const DescribedGroup& group, const ChamberPoreMetrics& metrics, const AnalysisConfig& config) {
    write_chambers(group.group("L"), metrics.all, config);
    const DescribedGroup separate = group.group("A");
    write_chambers(separate, metrics.separate, config);
    separate.value("n_beyond_data", "1", "circles that reach past the outermost particle centres along x",
                   metrics.n_beyond_data);
    write_chambers(group.group("B"), metrics.disjoint, config);
    if (!metrics.persistent) return;
    const DescribedGroup persistent = group.group("P");
    write_chambers(persistent, *metrics.persistent, config);
    persistent.column("persistence", "d_p", "fall of the gap on the best way to a larger circle",
                      metrics.persistent->persistence);
}

}  // namespace recoat
