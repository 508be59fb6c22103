#include "analyzer/readers/mercury_data.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "analyzer/readers/row_block.hpp"
#include "common/number.hpp"
#include "common/tables/text_cursor.hpp"

namespace recoat {
namespace {

constexpr std::size_t header_columns = 8, particle_columns = 14, flat_header_columns = 6;
const std::vector<std::string> columns = {"x",     "y",    "z",     "vx",     "vy",     "vz",     "radius",
                                          "alpha", "beta", "gamma", "omegax", "omegay", "omegaz", "species"};

struct Snapshot {
    TextCursor place;  ///< on the header
    std::size_t count = 0;
    double time = 0;
};

bool all_numbers(const std::vector<std::string_view>& cells) {
    return std::ranges::all_of(cells, [](std::string_view cell) { return parse_number(cell).has_value(); });
}

/// A header in three or in two dimensions.
bool is_header(const TextCursor& cursor) {
    const auto& cells = cursor.cells();
    if (cells.size() != header_columns && cells.size() != flat_header_columns) return false;
    const auto count = parse_integer(cells[0]);
    return count && *count >= 0 && all_numbers(cells);
}

bool is_next_header(TextCursor& line) {
    line.split();
    return is_header(line);
}

Snapshot read_header(TextCursor& cursor) {
    cursor.split();
    if (cursor.cells().size() == flat_header_columns && is_header(cursor)) {
        cursor.fail("the file is of a simulation in two dimensions, which has no layer; give one in three");
    }
    if (cursor.cells().size() != header_columns || !is_header(cursor)) {
        cursor.fail(
            fmt::format("the line has {} columns, but the head of a snapshot is a count and 7 numbers: N time "
                        "xmin ymin zmin xmax ymax zmax",
                        cursor.cells().size()));
    }
    return {cursor, static_cast<std::size_t>(cursor.integer(0, "N")), cursor.number(1, "time")};
}

Source read_particles_of(Snapshot snapshot, const ReadOptions& options) {
    TextCursor& cursor = snapshot.place;
    Source source;
    source.box = Box{.lower = {cursor.number(2, "xmin"), cursor.number(3, "ymin"), cursor.number(4, "zmin")},
                     .upper = {cursor.number(5, "xmax"), cursor.number(6, "ymax"), cursor.number(7, "zmax")},
                     .closed = false};  // a domain to look at, no wall
    for (std::size_t i = 0; i < snapshot.count; ++i) {
        cursor.need("a particle");
        cursor.split();
        if (cursor.cells().size() != particle_columns) {
            cursor.fail(fmt::format("the line has {} columns, but a particle has {}; correct the line",
                                    cursor.cells().size(), particle_columns));
        }
        source.position.push_back({cursor.number(0, "x"), cursor.number(1, "y"), cursor.number(2, "z")});
        constexpr std::size_t radius = 6, species = 13;
        source.radius.push_back(cursor.size(radius, columns[radius], options.allow_size_zero()));
        source.velocity.push_back(cursor.any_vector({3, 4, 5}, columns));
        source.angular_velocity.push_back(cursor.any_vector({10, 11, 12}, columns));
        source.type.add(cursor.cells()[species]);
        source.line.push_back(cursor.line_number());
    }
    return source;
}

}  // namespace

bool is_mercury_data(const Content& content) {
    if (!looks_like_text(content.head())) return false;
    TextCursor cursor({}, content.head());
    if (!cursor.next_filled()) return false;
    cursor.split();
    return is_header(cursor);
}

Series open_mercury_data(const Content& content, const ReadOptions& options) {
    TextCursor cursor(content.name(), content.bytes);
    std::vector<Snapshot> snapshots;
    Series series;
    scan_steps(series, [&] {
        if (!cursor.next_filled()) return false;
        Snapshot snapshot = read_header(cursor);
        pass_rows(cursor,
                  {.rows = snapshot.count,
                   .columns = particle_columns,
                   .what = fmt::format("{} particles of the snapshot {}", snapshot.count, snapshots.size())},
                  is_next_header);
        series.steps.push_back(static_cast<std::int64_t>(snapshots.size()));
        series.times.push_back(snapshot.time);
        snapshots.push_back(std::move(snapshot));
        return true;
    });
    series.read = [snapshots = std::move(snapshots), &options](std::size_t index) {
        Source source = read_particles_of(snapshots[index], options);
        source.facts = {{"snapshots", std::to_string(snapshots.size())},
                        {"snapshot", std::to_string(index)},
                        {"time", shortest(snapshots[index].time)}};
        return source;
    };
    return series;
}

}  // namespace recoat
