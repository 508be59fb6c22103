#include "analyzer/fields/grid_pores.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <span>

namespace recoat {
namespace {

/// Steps to the neighbours; the first four cross sides.
constexpr std::array<GridCell, 8> steps = {{{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}}};

class PoreFinder {
public:
    PoreFinder(const Map& map, double threshold, GridConnectivity connectivity)
        : map_(map),
          threshold_(threshold),
          steps_(std::span(steps).first(static_cast<std::size_t>(connectivity))),
          unwrapped_(map.values.size(), unvisited) {}

    std::vector<GridPore> run() {
        std::vector<GridPore> pores;
        for (int ix = 0; ix < map_.nx; ++ix) {
            for (int iy = 0; iy < map_.ny; ++iy) {
                if (in_pore(ix, iy) && unwrapped(ix, iy) == unvisited) pores.push_back(walk({ix, iy}));
            }
        }
        return pores;
    }

private:
    static constexpr int unvisited = std::numeric_limits<int>::min();

    [[nodiscard]] bool in_pore(int ix, int iy) const { return map_.at(ix, iy) < threshold_; }
    [[nodiscard]] int& unwrapped(int ix, int iy) { return unwrapped_[static_cast<std::size_t>(ix) * map_.ny + iy]; }

    GridPore walk(GridCell seed) {
        GridPore pore;
        pore.cells.push_back(seed);
        unwrapped(seed.ix, seed.iy) = seed.iy;
        for (std::size_t next = 0; next < pore.cells.size(); ++next) {
            const GridCell cell = pore.cells[next];
            for (const GridCell step : steps_) {
                const GridCell to = {cell.ix + step.ix, cell.iy + step.iy};
                if (to.ix < 0 || to.ix >= map_.nx) continue;
                const int wrapped = ((to.iy % map_.ny) + map_.ny) % map_.ny;
                if (!in_pore(to.ix, wrapped)) continue;
                int& known = unwrapped(to.ix, wrapped);
                if (known == unvisited) {
                    known = to.iy;
                    pore.cells.push_back(to);
                } else if (known != to.iy) {
                    pore.percolates = true;
                }
            }
        }
        return pore;
    }

    const Map& map_;
    double threshold_;
    std::span<const GridCell> steps_;
    std::vector<int> unwrapped_;
};

}  // namespace

std::vector<GridPore> grid_pores(const Map& map, double threshold, GridConnectivity connectivity) {
    return PoreFinder(map, threshold, connectivity).run();
}

}  // namespace recoat
