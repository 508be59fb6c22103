#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace recoat {

/// Rows first..last (inclusive) that an item takes part in; none when last < first.
struct RowRange {
    int first = 0, last = -1;
};

/// For every row of a map the items that take part in it, in ascending order: the row's owner adds them up in that
/// order, so that sums do not depend on the number of threads.
class RowLists {
public:
    RowLists(std::span<const RowRange> ranges, int rows);

    [[nodiscard]] std::span<const std::size_t> items(int row) const;

private:
    std::vector<std::size_t> start_;
    std::vector<std::size_t> item_;
};

}  // namespace recoat
