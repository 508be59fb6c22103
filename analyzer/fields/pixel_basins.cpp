#include "analyzer/fields/pixel_basins.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <utility>

namespace recoat {
namespace {

/// The highest way between each of the pairs of basins that have been met of late.
class PassCollector {
public:
    explicit PassCollector(std::vector<PixelPass>& passes) : passes_(passes), recent_(slots) {}

    void add(std::uint32_t a, std::uint32_t b, std::uint32_t squared) {
        if (a > b) std::swap(a, b);
        PixelPass& slot = recent_[(a * 0x9E3779B1U + b * 0x85EBCA77U) >> (32 - bits)];
        if (slot.first == a && slot.second == b) {
            slot.squared = std::max(slot.squared, squared);
            return;
        }
        flush(slot);
        slot = {squared, a, b};
    }
    void finish() {
        for (const PixelPass& slot : recent_) flush(slot);
    }

private:
    static constexpr unsigned bits = 13;
    static constexpr std::size_t slots = std::size_t{1} << bits;

    void flush(const PixelPass& slot) {
        if (slot.first != slot.second) passes_.push_back(slot);
    }

    std::vector<PixelPass>& passes_;
    std::vector<PixelPass> recent_;
};

class BasinFinder {
public:
    explicit BasinFinder(const PixelDistance& pixels) : pixels_(pixels), columns_(pixels.columns) {}

    PixelBasins run() {
        // Until all is found, `basin` holds the next pixel on the way up.
        basins_.basin.resize(pixels_.squared.size());
        looked_at_.assign(pixels_.squared.size(), Mark::yes);
        for (std::int64_t i = 0; i < pixels_.rows; ++i) climb_row(i);
        number_tops();
        for (std::int64_t i = 0; i < pixels_.rows; ++i) add_row(i);
        return std::move(basins_);
    }

private:
    /// No `char`, which the compiler must expect to be part of anything.
    enum class Mark : std::uint8_t { no, yes };

    static constexpr std::uint32_t numbered = 0x80000000;

    [[nodiscard]] std::uint32_t squared(std::int64_t p) const { return pixels_.squared[static_cast<std::size_t>(p)]; }
    [[nodiscard]] std::uint32_t& basin(std::int64_t p) { return basins_.basin[static_cast<std::size_t>(p)]; }

    /// Points every pixel of a row to the highest of its neighbours and itself; of equal ones to the last.
    void climb_row(std::int64_t i) {
        const std::int64_t first = i * columns_;
        const bool inner = i > 0 && i + 1 < pixels_.rows;
        for (const std::int64_t j : {std::int64_t{0}, columns_ - 1}) basin(first + j) = climb(i, j);
        if (!inner) {
            for (std::int64_t j = 1; j < columns_ - 1; ++j) basin(first + j) = climb(i, j);
            return;
        }
        const std::array<std::int64_t, 9> steps = {-columns_ - 1, -columns_, -columns_ + 1, -1, 0, 1,
                                                   columns_ - 1,  columns_,  columns_ + 1};
        const std::uint32_t* here = pixels_.squared.data() + first;
        std::uint32_t* up = basins_.basin.data() + first;
        Mark* level = looked_at_.data() + first;
        for (std::int64_t j = 1; j < columns_ - 1; ++j) {
            std::uint32_t highest = 0, best = 0;
            for (const std::int64_t step : steps) {
                const std::uint32_t value = here[j + step];
                best = value >= highest ? static_cast<std::uint32_t>(first + j + step) : best;
                highest = std::max(highest, value);
            }
            up[j] = here[j] == 0 ? PixelBasins::solid : best;
            level[j] = static_cast<Mark>(static_cast<int>(highest == here[j]) & static_cast<int>(highest != 0));
        }
    }
    [[nodiscard]] std::uint32_t climb(std::int64_t i, std::int64_t j) const {
        std::int64_t best = i * columns_ + j;
        if (squared(best) == 0) return PixelBasins::solid;
        for (std::int64_t a = std::max<std::int64_t>(i - 1, 0); a <= std::min(i + 1, pixels_.rows - 1); ++a) {
            for (const std::int64_t b : {j == 0 ? columns_ - 1 : j - 1, j, j == columns_ - 1 ? 0 : j + 1}) {
                const std::int64_t other = a * columns_ + b;
                if (squared(other) > squared(best) || (squared(other) == squared(best) && other > best)) best = other;
            }
        }
        return static_cast<std::uint32_t>(best);
    }

    /// From the next pixel on the way up to the number of the top; what is numbered, or solid, has the highest bit.
    void number_tops() {
        const auto size = static_cast<std::int64_t>(pixels_.squared.size());
        for (std::int64_t p = 0; p < size; ++p) {
            if (basin(p) != p) continue;
            basin(p) = numbered | static_cast<std::uint32_t>(basins_.tops.size());
            basins_.tops.push_back({squared(p), pixels_.begin + p / columns_, p % columns_, 0, 0, 0});
        }
        for (std::int64_t p = 0; p < size; ++p) {
            std::uint32_t number = basin(p);
            while ((number & numbered) == 0) number = basin(number);
            for (std::uint32_t q = static_cast<std::uint32_t>(p); (basin(q) & numbered) == 0;) {
                q = std::exchange(basin(q), number);
            }
        }
        for (std::uint32_t& here : basins_.basin) here = here == PixelBasins::solid ? here : here & ~numbered;
    }

    /// Marks the pixels of an inner row that lie between two basins, beside those that are as high as all around them.
    void mark_meetings(std::int64_t i) {
        const std::uint32_t *here = basins_.basin.data() + i * columns_, *before = here - columns_;
        Mark* mark = looked_at_.data() + i * columns_;
        for (std::int64_t j = 1; j < columns_ - 1; ++j) {
            const std::uint32_t own = here[j];
            const auto meets = [own](std::uint32_t other) {
                return static_cast<int>(other != own) & static_cast<int>(other != PixelBasins::solid);
            };
            const int any = meets(here[j - 1]) | meets(before[j - 1]) | meets(before[j]) | meets(before[j + 1]);
            mark[j] = static_cast<Mark>(static_cast<int>(mark[j]) | any);
        }
    }

    /// The first marked pixel of a row from a column on; the number of columns if there is none.
    [[nodiscard]] std::int64_t next_marked(std::int64_t i, std::int64_t j) const {
        const Mark* row = looked_at_.data() + i * columns_;
        const void* found = std::memchr(row + j, static_cast<int>(Mark::yes), static_cast<std::size_t>(columns_ - j));
        return found == nullptr ? columns_ : static_cast<const Mark*>(found) - row;
    }

    /// Adds the pixels of a row to the tops they belong to, and the ways to the pixels before them.
    void add_row(std::int64_t i) {
        if (i > 0) mark_meetings(i);
        for (std::int64_t j = next_marked(i, 0); j < columns_; j = next_marked(i, j + 1)) {
            const std::int64_t p = i * columns_ + j;
            const std::uint32_t own = basin(p);
            if (own == PixelBasins::solid) continue;
            PixelTop& top = basins_.tops[own];
            if (squared(p) == top.squared) {
                ++top.count;
                top.row_sum += pixels_.begin + i - top.row;
                top.column_sum += shorter_way(j - top.column, columns_);
            }
            const std::int64_t left = j == 0 ? columns_ - 1 : j - 1, right = j == columns_ - 1 ? 0 : j + 1;
            add_pass(p, i * columns_ + left);
            if (i == 0) continue;
            for (const std::int64_t b : {left, j, right}) add_pass(p, (i - 1) * columns_ + b);
        }
        if (i == pixels_.rows - 1) collector_.finish();
    }
    void add_pass(std::int64_t p, std::int64_t q) {
        const std::uint32_t own = basin(p), other = basin(q);
        if (own == other || other == PixelBasins::solid) return;
        collector_.add(own, other, std::min(squared(p), squared(q)));
    }

    const PixelDistance& pixels_;
    std::int64_t columns_;
    PixelBasins basins_;
    std::vector<Mark> looked_at_;  ///< pixels that tops or ways may depend on
    PassCollector collector_{basins_.passes};
};

}  // namespace

void PixelTop::absorb(const PixelTop& other, std::int64_t columns) {
    count += other.count;
    row_sum += other.row_sum + other.count * (other.row - row);
    column_sum += other.column_sum + other.count * shorter_way(other.column - column, columns);
}

PixelBasins pixel_basins(const PixelDistance& pixels) { return BasinFinder(pixels).run(); }

}  // namespace recoat
