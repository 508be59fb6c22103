#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "analyzer/fields/layer.hpp"

namespace recoat {

/// Particles sorted into boxes at least `reach` wide, so that all that lies within `reach` of a particle is in its own
/// box and the boxes around it. Periodic along y. There are at most a few boxes per particle, however far apart they
/// lie.
class CellList {
public:
    CellList(const Layer& layer, double reach);

    /// Calls visit(other) for every particle in the boxes around `particle`, itself included, each once.
    template <class Visit>
    void for_each_near(std::size_t particle, Visit visit) const {
        const Index cell = cell_of(particle);
        for (int i = std::max(cell.i - 1, 0); i <= std::min(cell.i + 1, nx_ - 1); ++i) {
            for (int step = 0; step < std::min(ny_, 3); ++step) {
                const int j = (cell.j + step + ny_ - 1) % ny_;
                for (int k = std::max(cell.k - 1, 0); k <= std::min(cell.k + 1, nz_ - 1); ++k) {
                    const std::size_t box = flat({i, j, k});
                    for (std::size_t s = start_[box]; s < start_[box + 1]; ++s) visit(item_[s]);
                }
            }
        }
    }

private:
    struct Index {
        int i, j, k;
    };

    [[nodiscard]] Index cell_of(std::size_t particle) const;
    [[nodiscard]] std::size_t flat(Index c) const { return (static_cast<std::size_t>(c.i) * ny_ + c.j) * nz_ + c.k; }

    const Layer& layer_;
    double x_min_ = 0, z_min_ = 0;
    double per_x_ = 0, per_y_ = 0, per_z_ = 0;  ///< boxes per length
    int nx_ = 1, ny_ = 1, nz_ = 1;
    std::vector<std::size_t> start_, item_;
};

}  // namespace recoat
