#include "analyzer/readers/lammps_dump.hpp"

#include <array>

#include <fmt/format.h>

#include "analyzer/readers/lammps_snapshot.hpp"
#include "analyzer/readers/row_block.hpp"
#include "common/error.hpp"
#include "common/tables/header.hpp"

namespace recoat {
namespace {

/// A coordinate in a dump: its column, and how to get a length from it.
struct Coordinate {
    std::size_t column = 0;
    bool scaled = false, unwrapped = false;
};

Coordinate find_axis(Header& header, char axis, const std::string& chosen) {
    if (!chosen.empty()) return {.column = header.choose(chosen)};
    struct Form {
        std::string_view ending;
        bool scaled, unwrapped;
    };
    constexpr std::array<Form, 4> forms = {
        {{"", false, false}, {"u", false, true}, {"s", true, false}, {"su", true, true}}};
    for (const Form& form : forms) {
        const auto column = find_column(header.bare_names(), fmt::format("{}{}", axis, form.ending));
        if (column) return {*column, form.scaled, form.unwrapped};
    }
    throw ColumnError(
        fmt::format("there is no column {0}, {0}s, {0}u or {0}su among those of the dump ({1}); dump the "
                    "positions of the atoms too, or choose the column with --set columns.{0}=NAME",
                    axis, quotable_list(header.names())));
}

/// Reads the atoms of one snapshot; the cursor stands on the line that names the columns.
class AtomReader {
public:
    AtomReader(const LammpsSnapshot& snapshot, TextCursor cursor, const ReadOptions& options)
        : snapshot_(snapshot),
          cursor_(std::move(cursor)),
          header_(snapshot.columns),
          allow_size_zero_(options.allow_size_zero()) {
        try {
            find_columns(options.columns);
            find_units();
        } catch (const ColumnError& error) {
            cursor_.fail(error.what());
        }
    }

    Source read() {
        Source source;
        source.box = snapshot_.box;
        for (std::size_t a = 0; a < 3; ++a) source.box->unwrapped[a] = axes_[a].unwrapped;
        source.own_unit = own_unit_;
        source.columns = snapshot_.columns;
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
            if (velocity_) source.velocity.push_back(vector(*velocity_, velocity_factors_));
            if (angular_velocity_) {
                source.angular_velocity.push_back(vector(*angular_velocity_, spin_factors_));
            }
            if (type_) source.type.add(cursor_.cells()[*type_]);
            source.line.push_back(cursor_.line_number());
        }
        return source;
    }

private:
    void find_columns(const ColumnNames& chosen) {
        axes_ = {find_axis(header_, 'x', chosen.x), find_axis(header_, 'y', chosen.y),
                 find_axis(header_, 'z', chosen.z)};
        size_ = choose_size(header_, chosen);
        const auto& names = header_.bare_names();
        id_ = find_column(names, "id");
        type_ = chosen.type.empty() ? find_usual_type(names) : header_.choose(chosen.type);
        if (!snapshot_.units.known()) return;
        velocity_ = find_velocity(names);
        angular_velocity_ = find_angular_velocity(names);
    }

    /// Units that the names of columns carry (dump_modify colname): that of lengths is that of the box too.
    void find_units() {
        own_unit_ = snapshot_.units.length;
        std::vector<std::size_t> lengths;
        for (const Coordinate& axis : axes_) {
            if (!axis.scaled) lengths.push_back(axis.column);
        }
        if (size_) lengths.push_back(size_->index);
        if (!lengths.empty() && lengths_have_units(header_, lengths)) {
            const double unit = header_.factor(lengths.front(), Dimension::length);
            for (const std::size_t column : lengths) {
                if (header_.factor(column, Dimension::length) == unit) continue;
                throw ColumnError(
                    fmt::format("the columns \"{}\" and \"{}\" name different units, but a dump has one; correct them",
                                quotable(snapshot_.columns[lengths.front()]), quotable(snapshot_.columns[column])));
            }
            if (own_unit_ && *own_unit_ != unit) {
                throw ColumnError(fmt::format(
                    "the columns name a unit of {} m, \"ITEM: UNITS\" one of {} m; correct them", unit, *own_unit_));
            }
            own_unit_ = unit;
        }
        // Those without a unit are in that of length per time, as complete() takes them.
        const double speed = own_unit_.value_or(1.0) / snapshot_.units.time, spin = 1 / snapshot_.units.time;
        if (velocity_) velocity_factors_ = factors(*velocity_, Dimension::speed, speed);
        if (angular_velocity_) spin_factors_ = factors(*angular_velocity_, Dimension::angular_velocity, spin);
    }

    [[nodiscard]] Vec3 factors(const VectorColumns& columns, Dimension dimension, double unit) const {
        const auto factor = [&](std::size_t column) {
            return header_.has_unit(column) ? header_.factor(column, dimension) / unit : 1.0;
        };
        return {factor(columns[0]), factor(columns[1]), factor(columns[2])};
    }

    [[nodiscard]] Vec3 vector(const VectorColumns& columns, const Vec3& factors) const {
        const Vec3 v = cursor_.any_vector(columns, snapshot_.columns);
        return {factors.x * v.x, factors.y * v.y, factors.z * v.z};
    }

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
    Header header_;
    bool allow_size_zero_;
    std::optional<double> own_unit_;  ///< of lengths [m]
    Vec3 velocity_factors_, spin_factors_;
    std::array<Coordinate, 3> axes_;
    std::optional<SizeColumn> size_;
    std::optional<std::size_t> id_, type_;
    std::optional<VectorColumns> velocity_, angular_velocity_;
};

bool is_item(TextCursor& line) { return line.line().starts_with("ITEM:"); }

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
        pass_rows(cursor,
                  {.rows = snapshot.count,
                   .columns = snapshot.columns.size(),
                   .what = fmt::format("{} atoms of the time step {}", snapshot.count, snapshot.step)},
                  is_item);
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
