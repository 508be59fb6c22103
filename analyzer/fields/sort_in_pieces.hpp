#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <tbb/parallel_sort.h>

#include "analyzer/fields/parallel.hpp"

namespace recoat {

/// Items for which sorting in pieces begins to pay, and about the items of a piece: it stays in the cache.
inline constexpr std::size_t sorted_piece = 1024;

/// Where each of the pieces begins that items are dealt into, by one number of theirs: even cells of it, and runs of
/// cells with some `sorted_piece` items together.
class SortPieces {
public:
    /// `least` and `greatest` of the numbers; they differ.
    SortPieces(std::size_t items, double least, double greatest)
        : least_(least), piece_of_(items / items_of_a_cell + 1) {
        per_unit_ = static_cast<double>(piece_of_.size()) / (greatest - least);
    }
    [[nodiscard]] std::size_t cell(double number) const {
        return std::min(static_cast<std::size_t>((number - least_) * per_unit_), piece_of_.size() - 1);
    }
    void count(double number) { ++piece_of_[cell(number)]; }

    /// After counting: the pieces.
    void close() {
        std::size_t items = 0;
        for (std::uint32_t& cell : piece_of_) {
            if (items - begin_.back() >= sorted_piece) begin_.push_back(items);
            items += cell;
            cell = static_cast<std::uint32_t>(begin_.size() - 1);
        }
        begin_.push_back(items);
    }
    [[nodiscard]] std::uint32_t piece(double number) const { return piece_of_[cell(number)]; }
    /// First places of the pieces, and the end of the last.
    [[nodiscard]] const std::vector<std::size_t>& begin() const { return begin_; }

private:
    static constexpr std::size_t items_of_a_cell = 16;

    double least_, per_unit_;
    std::vector<std::uint32_t> piece_of_;  ///< number of items of a cell; then its piece
    std::vector<std::size_t> begin_ = {0};
};

/// Sorts by `before`, a total order, in which a smaller number(item) always comes first. Takes a time proportional to
/// the number of items unless most share a small part of the range of the numbers: items are dealt into pieces, and
/// each piece is sorted by itself.
template <class Item, class Number, class Before>
void sort_in_pieces(std::vector<Item>& items, Number number, Before before) {
    if (items.size() < 2 * sorted_piece) return std::sort(items.begin(), items.end(), before);
    double least = number(items.front()), greatest = least;
    for (const Item& item : items) {
        const double value = number(item);
        least = std::min(least, value);
        greatest = std::max(greatest, value);
    }
    if (!(greatest > least)) return tbb::parallel_sort(items.begin(), items.end(), before);
    SortPieces pieces(items.size(), least, greatest);
    for (const Item& item : items) pieces.count(number(item));
    pieces.close();
    std::vector<std::size_t> next(pieces.begin().begin(), pieces.begin().end() - 1);
    std::vector<Item> dealt(items.size());
    for (const Item& item : items) dealt[next[pieces.piece(number(item))]++] = item;
    items.swap(dealt);
    for_each_in_parallel(next.size(), [&](std::size_t k) {
        const std::span<Item> piece = std::span(items).subspan(pieces.begin()[k], next[k] - pieces.begin()[k]);
        if (piece.size() < 32 * sorted_piece) {
            std::sort(piece.begin(), piece.end(), before);
        } else {
            tbb::parallel_sort(piece.begin(), piece.end(), before);
        }
    });
}

}  // namespace recoat
