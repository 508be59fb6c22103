#include "analyzer/readers/lammps_dump.hpp"

#include <array>

#include <fmt/format.h>

#include "analyzer/readers/lammps_snapshot.hpp"
#include "common/error.hpp"
#include "common/tables/columns.hpp"

namespace recoat {
namespace {

/// A coordinate in a dump: its column, and how to get a length from it.
struct Coordinate {
    std::size_t column = 0;
    bool scaled = false, unwrapped = false;
};

Coordinate find_axis(const LammpsSnapshot& snapshot, const TextCursor& cursor, char axis, const std::string& chosen) {
    if (!chosen.empty()) {
        if (const auto column = find_column(snapshot.columns, chosen)) return {.column = *column};
        cursor.fail(
            fmt::format("there is no column \"{}\"; the dump has: {}", chosen, quotable_list(snapshot.columns)));
    }
    struct Form {
        std::string_view ending;
        bool scaled, unwrapped;
    };
    constexpr std::array<Form, 4> forms = {
        {{"", false, false}, {"u", false, true}, {"s", true, false}, {"su", true, true}}};
    for (const Form& form : forms) {
        const auto column = find_column(snapshot.columns, fmt::format("{}{}", axis, form.ending));
        if (column) return {*column, form.scaled, form.unwrapped};
    }
    cursor.fail(
        fmt::format("there is no column {0}, {0}s, {0}u or {0}su among those of the dump ({1}); dump the "
                    "positions of the atoms too",
                    axis, quotable_list(snapshot.columns)));
}

/// Reads the atoms of one snapshot; the cursor stands on the line that names the columns.
class AtomReader {
public:
    AtomReader(const LammpsSnapshot& snapshot, TextCursor cursor, const ReadOptions& options)
        : snapshot_(snapshot), cursor_(std::move(cursor)), allow_size_zero_(options.allow_size_zero()) {
        const ColumnNames& chosen = options.columns;
        axes_ = {find_axis(snapshot, cursor_, 'x', chosen.x), find_axis(snapshot, cursor_, 'y', chosen.y),
                 find_axis(snapshot, cursor_, 'z', chosen.z)};
        size_ = find_size(snapshot.columns, chosen, [this](const std::string& problem) { cursor_.fail(problem); });
        id_ = find_column(snapshot.columns, "id");
        type_ = find_type(snapshot.columns, chosen, [this](const std::string& problem) { cursor_.fail(problem); });
        if (!snapshot.units.known()) return;
        velocity_ = find_velocity(snapshot.columns);
        angular_velocity_ = find_angular_velocity(snapshot.columns);
    }

    Source read() {
        Source source;
        source.box = snapshot_.box;
        for (std::size_t a = 0; a < 3; ++a) source.box->unwrapped[a] = axes_[a].unwrapped;
        source.own_unit = snapshot_.units.length;
        source.time_unit = snapshot_.units.time;
        const Vec3 low = snapshot_.box.lower, high = snapshot_.box.upper;
        // As many lines follow, or opening the file had failed.
        source.position.reserve(snapshot_.count);
        source.line.reserve(snapshot_.count);
        for (std::size_t i = 0; i < snapshot_.count; ++i) {
            next_atom();
            source.position.push_back(
                {coordinate(0, low.x, high.x), coordinate(1, low.y, high.y), coordinate(2, low.z, high.z)});
            if (size_) source.radius.push_back(radius());
            if (id_) source.id.push_back(cursor_.integer(*id_, "id"));
            if (velocity_) source.velocity.push_back(cursor_.any_vector(*velocity_, snapshot_.columns));
            if (angular_velocity_) {
                source.angular_velocity.push_back(cursor_.any_vector(*angular_velocity_, snapshot_.columns));
            }
            if (type_) source.type.add(cursor_.cells()[*type_]);
            source.line.push_back(cursor_.line_number());
        }
        return source;
    }

private:
    void next_atom() {
        cursor_.need("an atom");
        cursor_.split();
        if (cursor_.cells().size() == snapshot_.columns.size()) return;
        cursor_.fail(fmt::format("the line has {} columns, but \"ITEM: ATOMS\" names {}; make them agree",
                                 cursor_.cells().size(), snapshot_.columns.size()));
    }

    [[nodiscard]] double coordinate(std::size_t axis, double low, double high) const {
        const Coordinate& place = axes_[axis];
        const double value = cursor_.number(place.column, snapshot_.columns[place.column]);
        return place.scaled ? low + value * (high - low) : value;
    }

    [[nodiscard]] double radius() const {
        return size_->to_radius * cursor_.size(size_->index, snapshot_.columns[size_->index], allow_size_zero_);
    }

    const LammpsSnapshot& snapshot_;
    TextCursor cursor_;
    bool allow_size_zero_;
    std::array<Coordinate, 3> axes_;
    std::optional<SizeColumn> size_;
    std::optional<std::size_t> id_, type_;
    std::optional<VectorColumns> velocity_, angular_velocity_;
};

}  // namespace

bool is_lammps_dump(const Content& content) { return content.bytes.starts_with("ITEM:"); }

Series open_lammps_dump(const Content& content, const ReadOptions& options) {
    TextCursor cursor(content.name(), content.bytes);
    std::vector<LammpsSnapshot> snapshots;
    std::vector<TextCursor> places;
    Series series;
    scan_steps(series, [&] {
        if (!cursor.next_filled()) return false;
        LammpsSnapshot snapshot = read_lammps_header(cursor, snapshots.empty() ? nullptr : &snapshots.back());
        if (!snapshot.units.known() && !options.length_unit) {
            cursor.fail(
                fmt::format("the dump has the units \"{}\", which say no length in metres; give it with "
                            "--length-unit",
                            quotable(snapshot.units.style)));
        }
        const TextCursor place = cursor;
        cursor.skip(snapshot.count, fmt::format("{} atoms of the time step {}", snapshot.count, snapshot.step));
        places.push_back(place);
        series.steps.push_back(snapshot.step);
        snapshots.push_back(std::move(snapshot));
        return true;
    });
    for (const LammpsSnapshot& snapshot : snapshots) {
        if (snapshot.time && snapshot.units.known()) series.times.push_back(*snapshot.time);
    }
    if (series.times.size() != snapshots.size()) series.times.clear();
    series.read = [steps = series.steps, snapshots = std::move(snapshots), places = std::move(places),
                   &options](std::size_t index) {
        Source source = AtomReader(snapshots[index], places[index], options).read();
        source.facts = {{"snapshots", std::to_string(steps.size())},
                        {"steps", fmt::format("{} ... {}", steps.front(), steps.back())},
                        {"step", std::to_string(steps[index])},
                        {"columns", fmt::format("{}", fmt::join(snapshots[index].columns, " "))}};
        return source;
    };
    return series;
}

}  // namespace recoat
