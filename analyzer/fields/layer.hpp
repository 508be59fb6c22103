#pragma once

#include <cstddef>
#include <vector>

#include "analyzer/configuration.hpp"
#include "analyzer/readers/source.hpp"

namespace recoat {

/// Cells of the analysis over the region; the nodes are their centres.
struct Grid {
    int nx = 0, ny = 0;  ///< number of cells along x and y
    double spacing = 1;  ///< side of a cell [d_p]

    [[nodiscard]] double node(int index) const { return (index + 0.5) * spacing; }
    [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(nx) * ny; }
};

/// A layer in particle diameters: x from the start of the region, y wrapped into [0, width) from y_min, z from the
/// base. Particles keep the order of the file.
struct Layer {
    std::vector<double> x, y, z, radius;  ///< [N] d_p
    std::vector<char> in_region;          ///< [N] whether the centre is in [0, length)
    std::vector<std::size_t> file_index;  ///< [N] place of the particle in the file
    double length = 0, width = 0;         ///< of the region along x and of the period along y [d_p]
    double clearance = 0;                 ///< h_b [d_p]
    Grid grid;

    [[nodiscard]] std::size_t size() const { return x.size(); }
};

/// Brings the particles of a file into the frame of the analysis.
/// @throws InputError when a particle is so far away or so large that the unit of length must be wrong.
[[nodiscard]] Layer make_layer(const Source& source, const AnalysisConfig& config);

}  // namespace recoat
