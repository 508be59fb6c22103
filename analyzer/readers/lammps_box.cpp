#include "analyzer/readers/lammps_box.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "analyzer/readers/tilt.hpp"

namespace recoat {
namespace {

constexpr std::array<double Vec3::*, 3> axes = {&Vec3::x, &Vec3::y, &Vec3::z};

/// The next line of a box, with so many numbers.
void next_bounds(TextCursor& cursor, std::size_t numbers) {
    cursor.need("the bounds of the box");
    cursor.split();
    if (cursor.cells().size() == numbers) return;
    cursor.fail(fmt::format("the line has {} numbers, but the bounds of this box along one direction are {}",
                            cursor.cells().size(), numbers));
}

/// "avec", "bvec" or "cvec".
std::optional<std::size_t> edge_named(std::string_view word) {
    if (word.size() != 4 || word.substr(1) != "vec" || word[0] < 'a' || word[0] > 'c') return {};
    return static_cast<std::size_t>(word[0] - 'a');
}

}  // namespace

Box read_dump_box(TextCursor& cursor) {
    cursor.split();
    // The first three words are "ITEM:", "BOX" and "BOUNDS".
    std::vector<std::string_view> words(cursor.cells().begin() + 3, cursor.cells().end());
    const bool vectors = words.size() >= 2 && words[0] == "abc";
    const bool tilts = words.size() >= 3 && words[0] == "xy";
    words.erase(words.begin(), words.begin() + (vectors ? 2 : tilts ? 3 : 0));
    Box box;
    for (std::size_t a = 0; a < 3; ++a) {
        // Old dumps have no flags.
        box.periodic[a] = words.size() == 3 && words[a] == "pp";
        next_bounds(cursor, vectors ? 4 : tilts ? 3 : 2);
        if (vectors) {
            const double side = cursor.number(a, "edge");
            for (const std::size_t other : {(a + 1) % 3, (a + 2) % 3}) {
                require_no_tilt(cursor, cursor.number(other, "edge"), side);
            }
            box.lower.*axes[a] = cursor.number(3, "origin");
            box.upper.*axes[a] = box.lower.*axes[a] + side;
            continue;
        }
        box.lower.*axes[a] = cursor.number(0, "lower bound");
        box.upper.*axes[a] = cursor.number(1, "upper bound");
        if (tilts) require_no_tilt(cursor, cursor.number(2, "tilt"), box.upper.*axes[a] - box.lower.*axes[a]);
    }
    return box;
}

void DataBox::take(const TextCursor& cursor) {
    const auto& cells = cursor.cells();
    constexpr std::array<std::string_view, 3> lower = {"xlo", "ylo", "zlo"}, upper = {"xhi", "yhi", "zhi"};
    if (cells.size() == 4) {
        for (std::size_t a = 0; a < 3; ++a) {
            if (cells[2] != lower[a] || cells[3] != upper[a]) continue;
            box_.lower.*axes[a] = cursor.number(0, lower[a]);
            box_.upper.*axes[a] = cursor.number(1, upper[a]);
            ++bounds_;
        }
        if (const auto edge = edge_named(cells[3])) take_edge(cursor, *edge);
    } else if (cells.size() == 6 && cells[3] == "xy" && cells[4] == "xz" && cells[5] == "yz") {
        for (std::size_t i = 0; i < 3; ++i) {
            // xy and xz shift along x, yz along y.
            const double side = i < 2 ? box_.upper.x - box_.lower.x : box_.upper.y - box_.lower.y;
            require_no_tilt(cursor, cursor.number(i, cells[3 + i]), side);
        }
    } else if (cells.size() == 5 && cells[3] == "abc" && cells[4] == "origin") {
        box_.lower = {cursor.number(0, "origin"), cursor.number(1, "origin"), cursor.number(2, "origin")};
        ++edges_;
    }
}

void DataBox::take_edge(const TextCursor& cursor, std::size_t axis) {
    edge_.*axes[axis] = cursor.number(axis, "edge");
    for (const std::size_t other : {(axis + 1) % 3, (axis + 2) % 3}) {
        require_no_tilt(cursor, cursor.number(other, "edge"), edge_.*axes[axis]);
    }
    ++edges_;
}

std::optional<Box> DataBox::box() const {
    if (bounds_ == 3) return box_;
    if (edges_ != 4) return {};
    Box box = box_;
    box.upper = box.lower + edge_;
    return box;
}

}  // namespace recoat
