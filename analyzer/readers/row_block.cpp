#include "analyzer/readers/row_block.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "common/number.hpp"

namespace recoat {
namespace {

void refuse_first_odd_row(TextCursor cursor, const RowBlock& block, bool (*is_head)(TextCursor& line)) {
    for (std::size_t i = 0; i < block.rows && cursor.next(); ++i) {
        if (is_head(cursor)) {
            cursor.fail(
                fmt::format("after {} rows another head begins, but {} should stand before it; copy the file again "
                            "from where it was made",
                            i, block.what));
        }
        cursor.split();
        const auto& cells = cursor.cells();
        if (cells.empty()) cursor.fail(fmt::format("an empty line stands among the {}; remove it", block.what));
        if (cells.size() != block.columns) {
            cursor.fail(fmt::format("the line has {} columns, but each of the {} has {}; correct or remove it",
                                    cells.size(), block.what, block.columns));
        }
        if (std::ranges::none_of(cells, [](std::string_view cell) { return parse_number(cell).has_value(); })) {
            cursor.fail(
                fmt::format("the line has no numbers, but stands among the {}; correct or remove it", block.what));
        }
    }
}

}  // namespace

void pass_rows(TextCursor& cursor, const RowBlock& block, bool (*is_head)(TextCursor& line)) {
    const TextCursor before = cursor;
    for (std::size_t i = 0; i < block.rows; ++i) {
        if (cursor.next()) continue;
        refuse_first_odd_row(before, block, is_head);
        cursor.need(block.what);
    }
    TextCursor after = cursor;
    if (after.next_filled() && !is_head(after)) refuse_first_odd_row(before, block, is_head);
    cursor.need_line_end();
}

}  // namespace recoat
