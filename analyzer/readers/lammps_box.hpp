#pragma once

#include "analyzer/readers/source.hpp"
#include "common/tables/text_cursor.hpp"

namespace recoat {

/// The box of a dump: the line "ITEM: BOX BOUNDS ...", on which the cursor stands, and the three behind it. Boxes that
/// may be tilted but are not (tilt factors of zero, edges along the axes) are read as what they are.
/// @throws InputError when a line is damaged or the box is tilted.
[[nodiscard]] Box read_dump_box(TextCursor& cursor);

/// The box in the head of a data file, line by line.
class DataBox {
public:
    /// Takes the line that the cursor has cut, where it says something of the box. Throws InputError for a tilted box.
    void take(const TextCursor& cursor);
    /// The box, where all three directions have been said.
    [[nodiscard]] std::optional<Box> box() const;

private:
    void take_edge(const TextCursor& cursor, std::size_t axis);

    Box box_;
    int bounds_ = 0, edges_ = 0;
    Vec3 edge_;
};

}  // namespace recoat
