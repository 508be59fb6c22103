#pragma once

#include <cstdint>
#include <vector>

#include "analyzer/fields/layer.hpp"
#include "analyzer/fields/row_lists.hpp"

namespace recoat {

/// The top view in square pixels, `per_dp` along one d_p, of which a whole number must fit into the period; aligned
/// with the region and the period: rows along x, over the region and `margin` [d_p] beyond its ends, and columns along
/// y over one period. A pixel is solid where its centre is in a disk. Nothing is stored but the disks by rows; rows are
/// drawn when they are asked for.
class PixelRaster {
public:
    PixelRaster(const Layer& layer, double per_dp, double margin);

    [[nodiscard]] std::int64_t rows() const { return rows_; }
    [[nodiscard]] std::int64_t columns() const { return columns_; }

    /// Place of a row and of a column [d_p], from the start of the region and from y_min.
    [[nodiscard]] double x(double row) const { return (static_cast<double>(first_row_) + row + 0.5) / n_; }
    [[nodiscard]] double y(double column) const { return (column + 0.5) / n_; }

    /// Squared distance of every pixel of rows begin ... end - 1 to the nearest solid one of its own row, in pixel
    /// sides, the shorter way round the period; at most the square of `farthest`.
    [[nodiscard]] std::vector<std::uint32_t> distances_along_rows(std::int64_t begin, std::int64_t end) const;

    /// Distances are cut off here [pixel sides]: the sum of two squares still fits 32 bits.
    static constexpr std::uint32_t farthest = 46'340;

private:
    /// Marks the pixels of a disk in rows begin ... end - 1, of which `pixels` is the first.
    void draw(std::size_t disk, std::int64_t begin, std::int64_t end, std::uint32_t* pixels) const;

    const Layer& layer_;
    double n_;
    std::int64_t first_row_, rows_, columns_;
    RowLists disks_;  ///< by chunks of rows
};

}  // namespace recoat
