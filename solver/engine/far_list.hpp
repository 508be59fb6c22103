#pragma once

#include "solver/engine/neighbours.hpp"

namespace recoat {

/// First particle of each cell, of the particles [begin, end), which are in spatial order; `key` is scratch.
template <class Space>
void find_cells(Space& space, const Row* position, std::size_t begin, std::size_t end, const Cells& cells,
                typename Space::template Array<std::int64_t>& key,
                typename Space::template Array<std::int32_t>& start) {
    const std::size_t n = end - begin;
    key.resize(n);
    start.resize(static_cast<std::size_t>(cells.count()) + 1);
    const Row* rows = position + begin;
    std::int64_t* cell = key.data();
    std::int32_t* first = start.data();
    space.for_each(n, [=] RECOAT_LAMBDA(std::size_t i) { cell[i] = cells.key(rows[i]); });
    space.for_each(start.size(), [=] RECOAT_LAMBDA(std::size_t c) {
        std::size_t lower = 0, upper = n;
        while (lower < upper) {
            const std::size_t middle = (lower + upper) / 2;
            if (cell[middle] < static_cast<std::int64_t>(c))
                lower = middle + 1;
            else
                upper = middle;
        }
        first[c] = static_cast<std::int32_t>(begin + lower);
    });
}

/// Finds the partners of a particle among the awake, who come first, and the sleepers.
struct PartnerSearch {
    NeighbourSearch awake, asleep;
    std::size_t count_awake, count;

    template <class Found>
    RECOAT_HD void operator()(std::size_t i, Found&& found) const {
        if (i < count_awake) awake(static_cast<std::int32_t>(i), found);
        if (count_awake < count) asleep(static_cast<std::int32_t>(i), found);
    }
};

/// Pairs that could come close for a while: every pair with separation below a skin, found over cells.
/// Sorted by (first, second), first < second.
template <class Space>
struct FarList {
    template <class T>
    using Array = typename Space::template Array<T>;

    Array<std::int32_t> begin;   ///< [N + 1] where each particle's partners start
    Array<std::int32_t> second;  ///< ascending within each particle

    /// The first `awake` of the particles must be in spatial order for the same skin, and so must the others.
    void build(Space& space, const Array<Row>& position, std::size_t awake, double skin, double y_min,
               double y_period) {
        const std::size_t n = position.size();
        const Extent extent = extent_of(space, position.data(), n);
        const Cells cells = make_cells(extent, 2 * extent.largest_radius + skin, y_min, y_period);
        find_cells(space, position.data(), 0, awake, cells, key_, start_);
        if (awake < n) find_cells(space, position.data(), awake, n, cells, key_, asleep_start_);
        const Period period(y_period);
        const PartnerSearch search{{position.data(), cells, start_.data(), period, skin},
                                   {position.data(), cells, asleep_start_.data(), period, skin},
                                   awake,
                                   n};
        begin.resize(n + 1);
        std::int32_t* counts = begin.data();
        space.for_each(n + 1, [=] RECOAT_LAMBDA(std::size_t i) {
            std::int32_t count = 0;
            if (i < n) search(i, [&count](std::int32_t) { ++count; });
            counts[i] = count;
        });
        space.exclusive_scan(begin);
        second.resize(static_cast<std::size_t>(space.picked(begin, n, 1, 1).front()));
        std::int32_t* out = second.data();
        space.for_each(n, [=] RECOAT_LAMBDA(std::size_t i) {
            const std::int32_t first = counts[i];
            std::int32_t end = first;
            search(i, [&end, out, first](std::int32_t j) {
                std::int32_t at = end++;
                for (; at > first && out[at - 1] > j; --at) out[at] = out[at - 1];
                out[at] = j;
            });
        });
    }

private:
    Array<std::int64_t> key_;
    Array<std::int32_t> start_, asleep_start_;
};

}  // namespace recoat
