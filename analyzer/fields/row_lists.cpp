#include "analyzer/fields/row_lists.hpp"

#include <numeric>

namespace recoat {

RowLists::RowLists(std::span<const RowRange> ranges, int rows) : start_(static_cast<std::size_t>(rows) + 1, 0) {
    for (const RowRange& range : ranges) {
        for (int row = range.first; row <= range.last; ++row) ++start_[row + 1];
    }
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    item_.resize(start_.back());
    std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        for (int row = ranges[i].first; row <= ranges[i].last; ++row) item_[next[row]++] = i;
    }
}

std::span<const std::size_t> RowLists::items(int row) const {
    return std::span(item_).subspan(start_[row], start_[row + 1] - start_[row]);
}

}  // namespace recoat
