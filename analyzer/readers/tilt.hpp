#pragma once

#include <cmath>

#include "common/tables/text_cursor.hpp"

namespace recoat {

/// Throws InputError where a box of this side is tilted by more than round-off.
inline void require_no_tilt(const TextCursor& cursor, double tilt, double side) {
    constexpr double round_off = 1e-12;
    if (std::abs(tilt) <= round_off * std::abs(side)) return;
    cursor.fail("the box is triclinic (tilted), which has no meaning for a layer; write it from an orthogonal box");
}

}  // namespace recoat
