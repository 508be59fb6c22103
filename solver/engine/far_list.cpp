#include "solver/engine/far_list.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "solver/engine/cells.hpp"
#include "solver/engine/partner.hpp"

namespace recoat {

namespace {

double cell_side(const std::vector<Row>& position, double skin) {
    double largest = 0;
    for (const Row& p : position) largest = std::max(largest, p.w);
    return 2 * largest + skin;
}

/// Neighbour rows of a coordinate, each once, wrapped where the grid is.
int neighbours(std::int64_t at, std::int64_t count, bool periodic, std::int64_t (&out)[3]) {
    if (periodic && count < 3) {
        for (std::int64_t k = 0; k < count; ++k) out[k] = k;
        return static_cast<int>(count);
    }
    int found = 0;
    for (std::int64_t k = at - 1; k <= at + 1; ++k) {
        if (periodic)
            out[found++] = (k + count) % count;
        else if (k >= 0 && k < count)
            out[found++] = k;
    }
    return found;
}

/// Finds the partners of one particle among the particles, which are sorted by cell.
struct Search {
    const std::vector<Row>& position;
    const Cells& cells;
    const std::vector<std::int32_t>& start;  ///< [cells + 1]
    Period period;
    double skin;

    template <class Found>
    void operator()(std::int32_t i, const Found& found) const {
        const Row& p = position[static_cast<std::size_t>(i)];
        const std::int64_t x = cells.coordinate(0, p);
        std::int64_t ys[3], zs[3];
        const int ny = neighbours(cells.coordinate(1, p), cells.along(1), cells.periodic(), ys);
        const int nz = neighbours(cells.coordinate(2, p), cells.along(2), false, zs);
        const std::int64_t left = std::max<std::int64_t>(0, x - 1), right = std::min(cells.along(0) - 1, x + 1);
        for (int a = 0; a < ny; ++a) {
            for (int b = 0; b < nz; ++b) {
                const std::int32_t lo = start[static_cast<std::size_t>(cells.key(left, ys[a], zs[b]))];
                const std::int32_t hi = start[static_cast<std::size_t>(cells.key(right, ys[a], zs[b])) + 1];
                for (std::int32_t j = std::max(lo, i + 1); j < hi; ++j) test(p, j, found);
            }
        }
    }

    template <class Found>
    void test(const Row& p, std::int32_t j, const Found& found) const {
        const Row& q = position[static_cast<std::size_t>(j)];
        const double reach = p.w + q.w + skin;
        if (squared_norm(period.nearest(q.xyz() - p.xyz())) < reach * reach) found(j);
    }
};

}  // namespace

std::vector<std::int32_t> spatial_order(const std::vector<Row>& position, const std::vector<std::int64_t>& id,
                                        double skin, double y_min, double y_period) {
    const Cells cells(position, cell_side(position, skin), y_min, y_period);
    std::vector<std::int64_t> key(position.size());
    for (std::size_t i = 0; i < position.size(); ++i) key[i] = cells.key(position[i]);
    std::vector<std::int32_t> order(position.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
        const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
        return key[i] != key[j] ? key[i] < key[j] : id[i] < id[j];
    });
    return order;
}

void FarList::build(OpenMP& space, const std::vector<Row>& position, double skin, double y_min, double y_period) {
    const std::size_t n = position.size();
    const Cells cells(position, cell_side(position, skin), y_min, y_period);
    std::vector<std::int32_t> start(static_cast<std::size_t>(cells.count()) + 1, 0);
    for (const Row& p : position) ++start[static_cast<std::size_t>(cells.key(p)) + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());

    const Search search{position, cells, start, Period(y_period), skin};
    begin.assign(n + 1, 0);
    space.for_each(n, [&](std::size_t i) {
        std::size_t count = 0;
        search(static_cast<std::int32_t>(i), [&](std::int32_t) { ++count; });
        begin[i + 1] = count;
    });
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    second.resize(begin[n]);
    space.for_each(n, [&](std::size_t i) {
        auto* out = second.data() + begin[i];
        search(static_cast<std::int32_t>(i), [&](std::int32_t j) { *out++ = j; });
        std::sort(second.data() + begin[i], out);
    });
}

}  // namespace recoat
