#include "analyzer/readers/lammps_velocities.hpp"

#include <string>
#include <unordered_map>

#include <fmt/format.h>

#include "common/number.hpp"

namespace recoat {
namespace {

constexpr std::size_t linear_columns = 4, all_columns = 7;
const std::vector<std::string> names = {"id", "vx", "vy", "vz", "omegax", "omegay", "omegaz"};

/// Places of particles by identity; a place is taken away when its line has been read.
using Places = std::unordered_map<std::int64_t, std::size_t>;

/// To the next line that is more than a comment.
bool next_content(TextCursor& cursor) {
    while (cursor.next_filled()) {
        cursor.drop_comment('#');
        if (!trimmed(cursor.line()).empty()) return true;
    }
    return false;
}

std::size_t take_place(const TextCursor& cursor, Places& places) {
    const std::int64_t id = cursor.integer(0, "id");
    const auto found = places.find(id);
    if (found == places.end()) {
        cursor.fail(
            fmt::format("the section Velocities gives a velocity to the atom {}, which is not there or has one; "
                        "give every atom one",
                        id));
    }
    const std::size_t place = found->second;
    places.erase(found);
    return place;
}

}  // namespace

void read_lammps_velocities(TextCursor& cursor, Source& source) {
    Places places;
    for (std::size_t i = 0; i < source.id.size(); ++i) places[source.id[i]] = i;
    if (places.size() != source.id.size()) return;  // an identity is there twice, which is refused later
    source.velocity.resize(source.position.size());
    for (std::size_t i = 0; i < source.position.size(); ++i) {
        if (!next_content(cursor)) {
            cursor.fail(
                fmt::format("the section Velocities ends after {} of {} atoms; copy the file again from where it "
                            "was made",
                            i, source.position.size()));
        }
        cursor.split();
        const std::size_t columns = cursor.cells().size();
        if (columns != linear_columns && columns != all_columns) {
            cursor.fail(
                fmt::format("the line has {} columns, but those of the section Velocities have {} or {}; correct "
                            "the line",
                            columns, linear_columns, all_columns));
        }
        const std::size_t place = take_place(cursor, places);
        source.velocity[place] = cursor.any_vector({1, 2, 3}, names);
        if (columns != all_columns) continue;
        source.angular_velocity.resize(source.position.size());
        source.angular_velocity[place] = cursor.any_vector({4, 5, 6}, names);
    }
}

}  // namespace recoat
