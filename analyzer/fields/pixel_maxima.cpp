#include "analyzer/fields/pixel_maxima.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>

#include <tbb/parallel_sort.h>

#include "analyzer/fields/parallel.hpp"
#include "analyzer/fields/pixel_strip.hpp"

namespace recoat {
namespace {

/// Pixels of a strip, about: what is computed of them stays in the cache.
constexpr std::int64_t strip_pixels = 1 << 18;
/// Rows at least: each strip looks at rows beyond it too.
constexpr std::int64_t least_rows = 64;

/// Merges from high to low what the strips have left.
class Merger {
public:
    Merger(std::vector<PixelTop> tops, std::int64_t columns, double height)
        : tops_(std::move(tops)), columns_(columns), height_(height), set_(tops_.size()) {
        std::iota(set_.begin(), set_.end(), 0U);
        next_ = set_;
        part_.assign(tops_.size(), false);
    }

    std::vector<PixelTop> run(std::vector<PixelPass>& passes) {
        tbb::parallel_sort(passes.begin(), passes.end());
        for (const PixelPass& pass : passes) join(pass);
        for (std::uint32_t top = 0; top < tops_.size(); ++top) {
            if (set_[top] == top) end(top, 0);
        }
        return std::move(maxima_);
    }

private:
    std::uint32_t find(std::uint32_t top) {
        while (set_[top] != top) top = set_[top] = set_[set_[top]];
        return top;
    }

    /// Of tops of different height the lower ends here; equal ones go on together, in a ring, and end together. Pixels
    /// of one height that touch are one top.
    void join(const PixelPass& pass) {
        std::uint32_t elder = find(pass.first), younger = find(pass.second);
        if (elder == younger) return;
        if (tops_[elder].squared < tops_[younger].squared) std::swap(elder, younger);
        set_[younger] = elder;
        if (tops_[elder].squared > tops_[younger].squared) {
            end(younger, pass.squared);
        } else if (tops_[elder].squared == pass.squared) {
            tops_[elder].absorb(tops_[younger], columns_);
            part_[younger] = true;
        } else {
            std::swap(next_[elder], next_[younger]);
        }
    }
    void end(std::uint32_t ring, std::uint32_t level) {
        if (!falls_by(tops_[ring].squared, level, height_)) return;
        std::uint32_t top = ring;
        do {
            if (!part_[top]) maxima_.push_back(tops_[top]);
            top = next_[top];
        } while (top != ring);
    }

    std::vector<PixelTop> tops_;
    std::int64_t columns_;
    double height_;
    std::vector<std::uint32_t> set_, next_;
    std::vector<bool> part_;
    std::vector<PixelTop> maxima_;
};

/// Ways between the pixels of the last row of a strip and those of the first row of the one after it.
void join_borders(const PixelBorder& last, std::uint32_t last_offset, const PixelBorder& first,
                  std::uint32_t first_offset, std::vector<PixelPass>& passes) {
    const auto columns = static_cast<std::int64_t>(last.top.size());
    for (std::int64_t j = 0; j < columns; ++j) {
        const auto p = static_cast<std::size_t>(j);
        if (last.top[p] == PixelBasins::solid) continue;
        for (const std::int64_t b : {j == 0 ? columns - 1 : j - 1, j, j == columns - 1 ? 0 : j + 1}) {
            const auto q = static_cast<std::size_t>(b);
            if (first.top[q] == PixelBasins::solid) continue;
            const PixelPass pass = {std::min(last.squared[p], first.squared[q]), last.top[p] + last_offset,
                                    first.top[q] + first_offset};
            const bool repeated =
                !passes.empty() && passes.back().first == pass.first && passes.back().second == pass.second;
            if (repeated) {
                passes.back().squared = std::max(passes.back().squared, pass.squared);
            } else {
                passes.push_back(pass);
            }
        }
    }
}

std::vector<PixelTop> maxima_of(std::vector<PixelStrip>& strips, std::int64_t columns, double height) {
    std::vector<PixelTop> tops, maxima;
    std::vector<PixelPass> passes;
    std::vector<std::uint32_t> offset;
    for (PixelStrip& strip : strips) {
        offset.push_back(static_cast<std::uint32_t>(tops.size()));
        tops.insert(tops.end(), strip.tops.begin(), strip.tops.end());
        maxima.insert(maxima.end(), strip.maxima.begin(), strip.maxima.end());
        for (const PixelPass& pass : strip.passes) {
            passes.push_back({pass.squared, pass.first + offset.back(), pass.second + offset.back()});
        }
        strip.tops = {};
        strip.maxima = {};
        strip.passes = {};
    }
    for (std::size_t s = 1; s < strips.size(); ++s) {
        join_borders(strips[s - 1].last, offset[s - 1], strips[s].first, offset[s], passes);
    }
    for (const PixelTop& top : Merger(std::move(tops), columns, height).run(passes)) maxima.push_back(top);
    return maxima;
}

PixelMaximum place_of(const PixelTop& top) {
    const auto mean = [&](std::int64_t origin, std::int64_t sum) {
        return static_cast<double>(origin) + static_cast<double>(sum) / static_cast<double>(top.count);
    };
    return {mean(top.row, top.row_sum), mean(top.column, top.column_sum), std::sqrt(static_cast<double>(top.squared))};
}

}  // namespace

std::vector<PixelMaximum> pixel_maxima(const PixelRaster& raster, double height, std::int64_t strip_rows) {
    if (strip_rows == 0) strip_rows = std::max(strip_pixels / raster.columns(), least_rows);
    std::vector<PixelStrip> strips(static_cast<std::size_t>((raster.rows() + strip_rows - 1) / strip_rows));
    for_each_in_parallel(strips.size(), [&](std::size_t s) {
        const std::int64_t begin = static_cast<std::int64_t>(s) * strip_rows;
        const std::int64_t end = std::min(begin + strip_rows, raster.rows());
        strips[s] = pixel_strip(pixel_distance(raster, begin, end), height, s > 0, end < raster.rows());
    });
    if (std::ranges::none_of(strips, &PixelStrip::has_solid)) return {};
    std::vector<PixelMaximum> result;
    for (const PixelTop& top : maxima_of(strips, raster.columns(), height)) result.push_back(place_of(top));
    std::ranges::sort(result, [](const PixelMaximum& a, const PixelMaximum& b) {
        return std::tuple(-a.distance, a.row, a.column) < std::tuple(-b.distance, b.row, b.column);
    });
    return result;
}

}  // namespace recoat
