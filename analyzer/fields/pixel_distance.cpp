#include "analyzer/fields/pixel_distance.hpp"

#include <algorithm>
#include <array>

namespace recoat {
namespace {

/// Columns that are searched together: as many as a few vector registers hold.
constexpr std::int64_t group = 64;

/// Finds the nearest solid pixel of every pixel of a row from the distances along the rows above and below, nearest
/// rows first, until none can be nearer.
class RowSearch {
public:
    RowSearch(const PixelRaster& raster, std::int64_t begin, std::int64_t end)
        : raster_(raster), begin_(begin), end_(end), along_(raster.distances_along_rows(begin, end)) {}

    /// False if rows that are not loaded may matter.
    [[nodiscard]] bool run(std::int64_t row, std::uint32_t* result) const {
        for (std::int64_t j = 0; j < raster_.columns(); j += group) {
            const std::int64_t width = std::min(group, raster_.columns() - j);
            const bool found =
                width == group ? search<group>(row, j, group, result + j) : search<0>(row, j, width, result + j);
            if (!found) return false;
        }
        return true;
    }

private:
    /// A group of `width` columns; the width is known when the program is built if `fixed` is not 0.
    template <std::int64_t fixed>
    [[nodiscard]] bool search(std::int64_t row, std::int64_t column, std::int64_t width, std::uint32_t* result) const {
        const std::int64_t columns = fixed == 0 ? width : fixed;
        std::array<std::uint32_t, group> nearest{};
        std::copy_n(at(row, column), columns, nearest.begin());
        for (std::int64_t step = 1;; ++step) {
            std::uint32_t largest = 0;
            for (std::int64_t j = 0; j < columns; ++j) largest = std::max(largest, nearest[j]);
            const auto square = static_cast<std::uint32_t>(std::min<std::int64_t>(step, PixelRaster::farthest) *
                                                           std::min<std::int64_t>(step, PixelRaster::farthest));
            if (square >= largest) break;
            const std::int64_t above = row - step, below = row + step;
            if (above < 0 && below >= raster_.rows()) break;
            if ((above >= 0 && above < begin_) || (below < raster_.rows() && below >= end_)) return false;
            const std::uint32_t* up = at(above >= 0 ? above : below, column);
            const std::uint32_t* down = at(below < raster_.rows() ? below : above, column);
            for (std::int64_t j = 0; j < columns; ++j) {
                nearest[j] = std::min(nearest[j], square + std::min(up[j], down[j]));
            }
        }
        std::copy_n(nearest.begin(), columns, result);
        return true;
    }
    [[nodiscard]] const std::uint32_t* at(std::int64_t row, std::int64_t column) const {
        return along_.data() + (row - begin_) * raster_.columns() + column;
    }

    const PixelRaster& raster_;
    std::int64_t begin_, end_;
    std::vector<std::uint32_t> along_;
};

}  // namespace

PixelDistance pixel_distance(const PixelRaster& raster, std::int64_t begin, std::int64_t end) {
    PixelDistance result{begin, end - begin, raster.columns(), {}};
    result.squared.resize(static_cast<std::size_t>(result.rows * result.columns));
    for (std::int64_t reach = 32;; reach *= 2) {
        const RowSearch search(raster, std::max<std::int64_t>(begin - reach, 0), std::min(end + reach, raster.rows()));
        std::int64_t row = begin;
        while (row < end && search.run(row, result.squared.data() + (row - begin) * result.columns)) ++row;
        if (row == end) return result;
    }
}

}  // namespace recoat
