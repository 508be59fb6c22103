#include "analyzer/fields/pixel_raster.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace recoat {
namespace {

/// A centre this close outside a disk counts as inside, whatever the round-off [d_p].
constexpr double rim = 1e-9;
constexpr std::int64_t chunk_rows = 64;

/// The disks that may reach into each chunk of rows.
RowLists by_chunks(const Layer& layer, double n, std::int64_t first_row, std::int64_t rows) {
    const auto chunks = static_cast<int>((rows + chunk_rows - 1) / chunk_rows);
    std::vector<RowRange> ranges(layer.size());
    for (std::size_t p = 0; p < layer.size(); ++p) {
        const double low = (layer.x[p] - layer.radius[p]) * n - 1, high = (layer.x[p] + layer.radius[p]) * n + 1;
        const double first = (std::floor(low) - static_cast<double>(first_row)) / chunk_rows;
        const double last = (std::ceil(high) - static_cast<double>(first_row)) / chunk_rows;
        if (last < 0 || first >= chunks) continue;
        ranges[p] = {std::max(static_cast<int>(std::floor(first)), 0),
                     std::min(static_cast<int>(std::floor(last)), chunks - 1)};
    }
    return {ranges, chunks};
}

/// Squared distances of the pixels begin ... end - 1 of a run of `length` pixels between two solid ones.
void measure_run(std::uint32_t* pixels, std::int64_t begin, std::int64_t end, std::int64_t length) {
    for (std::int64_t k = begin; k < end; ++k) {
        const auto distance =
            static_cast<std::uint32_t>(std::min<std::int64_t>(std::min(k + 1, length - k), PixelRaster::farthest));
        pixels[k - begin] = distance * distance;
    }
}

/// From marks of solid pixels (0) to squared distances along a row.
void measure_row(std::uint32_t* row, std::int64_t columns) {
    constexpr std::uint32_t farthest = PixelRaster::farthest;
    const std::int64_t first = std::find(row, row + columns, 0U) - row;
    if (first == columns) {
        std::fill(row, row + columns, farthest * farthest);
        return;
    }
    std::int64_t last = first;
    for (std::int64_t j = first + 1; j < columns; ++j) {
        if (row[j] != 0) continue;
        if (j > last + 1) measure_run(row + last + 1, 0, j - last - 1, j - last - 1);
        last = j;
    }
    // The run that goes on from the last column to the first.
    const std::int64_t behind = columns - 1 - last, length = behind + first;
    measure_run(row + last + 1, 0, behind, length);
    measure_run(row, behind, length, length);
}

}  // namespace

PixelRaster::PixelRaster(const Layer& layer, double per_dp, double margin)
    : layer_(layer),
      n_(per_dp),
      first_row_(-static_cast<std::int64_t>(std::ceil(margin * n_))),
      rows_(static_cast<std::int64_t>(std::ceil((layer.length + margin) * n_)) - first_row_),
      columns_(std::llround(layer.width * n_)),
      disks_(by_chunks(layer, n_, first_row_, rows_)) {}

void PixelRaster::draw(std::size_t disk, std::int64_t begin, std::int64_t end, std::uint32_t* pixels) const {
    const double x = layer_.x[disk], y = layer_.y[disk], radius = layer_.radius[disk] + rim;
    const std::int64_t first = static_cast<std::int64_t>(std::floor((x - radius) * n_)) - first_row_;
    const std::int64_t last = static_cast<std::int64_t>(std::ceil((x + radius) * n_)) - first_row_;
    for (std::int64_t i = std::max(first, begin); i <= std::min(last, end - 1); ++i) {
        const double dx = this->x(static_cast<double>(i)) - x, left = radius * radius - dx * dx;
        if (left < 0) continue;
        const double half = std::sqrt(left);
        const auto low = static_cast<std::int64_t>(std::ceil((y - half) * n_ - 0.5));
        const auto high = static_cast<std::int64_t>(std::floor((y + half) * n_ - 0.5));
        std::uint32_t* row = pixels + (i - begin) * columns_;
        if (low >= 0 && high < columns_) {
            std::fill(row + low, row + std::max(low, high + 1), 0);
            continue;
        }
        for (std::int64_t j = low; j <= std::min(high, low + columns_ - 1); ++j) {
            row[j >= 0 && j < columns_ ? j : ((j % columns_) + columns_) % columns_] = 0;
        }
    }
}

std::vector<std::uint32_t> PixelRaster::distances_along_rows(std::int64_t begin, std::int64_t end) const {
    std::vector<std::uint32_t> pixels(static_cast<std::size_t>((end - begin) * columns_), farthest);
    for (std::int64_t chunk = begin / chunk_rows; chunk * chunk_rows < end; ++chunk) {
        const std::int64_t first = std::max(begin, chunk * chunk_rows), last = std::min(end, (chunk + 1) * chunk_rows);
        for (const std::size_t disk : disks_.items(static_cast<int>(chunk))) {
            draw(disk, first, last, pixels.data() + (first - begin) * columns_);
        }
    }
    for (std::int64_t i = 0; i < end - begin; ++i) measure_row(pixels.data() + i * columns_, columns_);
    return pixels;
}

}  // namespace recoat
