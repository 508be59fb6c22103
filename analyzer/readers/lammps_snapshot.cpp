#include "analyzer/readers/lammps_snapshot.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "analyzer/readers/lammps_box.hpp"
#include "common/number.hpp"

namespace recoat {
namespace {

void read_columns(TextCursor& cursor, std::string_view names, LammpsSnapshot& snapshot) {
    cursor.split();
    for (std::size_t i = 2; i < cursor.cells().size(); ++i) snapshot.columns.push_back(lower_case(cursor.cells()[i]));
    if (trimmed(names).empty()) {
        cursor.fail(
            "\"ITEM: ATOMS\" does not name its columns; add their names, e.g. ITEM: ATOMS id type x y z radius");
    }
}

/// Whether the line is this item; `rest` is what follows on it.
bool is_item(std::string_view line, std::string_view item, std::string_view& rest) {
    if (!line.starts_with(item)) return false;
    rest = line.substr(item.size());
    return true;
}

struct Found {
    bool step = false, count = false, box = false;
};

/// The number of the step, which some programs write as a real one (1e+06).
std::int64_t read_step(const TextCursor& cursor) {
    constexpr double largest = 0x1p53;
    const auto real = parse_number(trimmed(cursor.line()));
    if (real && *real >= 0 && *real <= largest && *real == std::floor(*real)) return static_cast<std::int64_t>(*real);
    return static_cast<std::int64_t>(cursor.count("number of a time step"));
}

/// Reads one item; true when it was the last, the names of the columns.
bool read_item(TextCursor& cursor, LammpsSnapshot& snapshot, Found& found) {
    const std::string_view line = cursor.line();
    std::string_view rest;
    if (is_item(line, "ITEM: TIMESTEP", rest)) {
        cursor.need("the number of the time step");
        snapshot.step = read_step(cursor);
        found.step = true;
    } else if (is_item(line, "ITEM: UNITS", rest)) {
        cursor.need("the name of the units");
        snapshot.units = lammps_units(trimmed(cursor.line()));
    } else if (is_item(line, "ITEM: TIME", rest)) {
        cursor.need("the time");
        snapshot.time = parse_number(trimmed(cursor.line()));
    } else if (is_item(line, "ITEM: NUMBER OF ATOMS", rest)) {
        cursor.need("the number of atoms");
        snapshot.count = cursor.count("number of atoms");
        found.count = true;
    } else if (is_item(line, "ITEM: BOX BOUNDS", rest)) {
        snapshot.box = read_dump_box(cursor);
        found.box = true;
    } else if (is_item(line, "ITEM: ATOMS", rest)) {
        read_columns(cursor, rest, snapshot);
        return true;
    } else if (is_item(line, "ITEM: NUMBER OF ENTRIES", rest) || is_item(line, "ITEM: ENTRIES", rest)) {
        cursor.fail("this dump lists local entries such as contacts, not particles; give a dump of atoms");
    } else if (!line.starts_with("ITEM:")) {
        cursor.fail(
            fmt::format("\"{}\" stands where an item should begin (ITEM: ...), behind all atoms that the last "
                        "snapshot announces; make their number agree, or copy the file again",
                        quotable(line)));
    } else {
        cursor.fail(fmt::format("\"{}\" is no item of a dump of atoms; copy the file again from where it was made",
                                quotable(line)));
    }
    return false;
}

}  // namespace

LammpsUnits lammps_units(std::string_view style) {
    struct Known {
        std::string_view style;
        double length, time;
    };
    constexpr std::array<Known, 7> all = {{{"si", 1, 1},
                                           {"cgs", 1e-2, 1},
                                           {"micro", 1e-6, 1e-6},
                                           {"nano", 1e-9, 1e-9},
                                           {"real", 1e-10, 1e-15},
                                           {"metal", 1e-10, 1e-12},
                                           {"electron", 5.29177210903e-11, 1e-15}}};
    for (const Known& known : all) {
        if (known.style == style) return {std::string(style), known.length, known.time};
    }
    return {.style = std::string(style), .length = {}};
}

LammpsSnapshot read_lammps_header(TextCursor& cursor, const LammpsSnapshot* previous) {
    LammpsSnapshot snapshot;
    if (previous != nullptr) snapshot.units = previous->units;
    Found found;
    while (!read_item(cursor, snapshot, found)) cursor.need("\"ITEM: ATOMS\"");
    if (found.step && found.count && found.box) return snapshot;
    cursor.fail(fmt::format("there is no \"{}\" before the atoms; copy the file again from where it was made",
                            !found.step    ? "ITEM: TIMESTEP"
                            : !found.count ? "ITEM: NUMBER OF ATOMS"
                                           : "ITEM: BOX BOUNDS"));
}

}  // namespace recoat
