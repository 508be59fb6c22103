#include "analyzer/readers/extended_xyz.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "analyzer/readers/row_block.hpp"
#include "analyzer/readers/xyz_comment.hpp"
#include "common/number.hpp"
#include "common/tables/columns.hpp"
#include "common/tables/text_cursor.hpp"

namespace recoat {
namespace {

struct Frame {
    TextCursor place;  ///< on the comment
    std::size_t count = 0;
    XyzComment comment;
};

/// The columns of the position: one property of three, or three of one.
VectorColumns find_position(const std::vector<std::string>& names, const ColumnNames& chosen,
                            const TextCursor& cursor) {
    VectorColumns columns = {};
    for (const auto& [axis, own] : {std::pair(0, &chosen.x), std::pair(1, &chosen.y), std::pair(2, &chosen.z)}) {
        std::optional<std::size_t> column;
        if (!own->empty()) {
            column = find_column(names, *own);
        } else {
            for (const auto form : {"pos:{}", "position:{}", "positions:{}", "coordinates:{}"}) {
                if (!column) column = find_column(names, fmt::format(fmt::runtime(form), axis));
            }
            if (!column) column = find_coordinate(names, static_cast<char>('x' + axis));
        }
        if (!column) {
            cursor.fail(fmt::format("there is no column {} among the Properties ({}); give pos:R:3",
                                    own->empty() ? fmt::format("of {}", static_cast<char>('x' + axis)) : quotable(*own),
                                    quotable_list(names)));
        }
        columns[static_cast<std::size_t>(axis)] = *column;
    }
    return columns;
}

/// Reads the particles of one frame.
class FrameReader {
public:
    FrameReader(Frame frame, const ReadOptions& options)
        : frame_(std::move(frame)),
          cursor_(frame_.place),
          names_(xyz_columns(frame_.comment, cursor_)),
          allow_size_zero_(options.allow_size_zero()) {
        const ColumnNames& chosen = options.columns;
        const auto fail = [this](const std::string& problem) { cursor_.fail(problem); };
        position_ = find_position(names_, chosen, cursor_);
        size_ = find_size(names_, chosen, fail);
        type_ = find_type(names_, chosen, fail);
        id_ = find_id(names_);
        velocity_ = find_velocity(names_);
        angular_velocity_ = find_angular_velocity(names_);
    }

    Source read() {
        Source source;
        source.box = xyz_box(frame_.comment, cursor_);
        // As many lines follow, or opening the file had failed.
        source.position.reserve(frame_.count);
        for (std::size_t i = 0; i < frame_.count; ++i) {
            next_particle();
            source.position.push_back(cursor_.vector(position_, names_));
            if (size_)
                source.radius.push_back(size_->to_radius *
                                        cursor_.size(size_->index, names_[size_->index], allow_size_zero_));
            if (id_) source.id.push_back(cursor_.integer(*id_, names_[*id_]));
            if (type_) source.type.add(cursor_.cells()[*type_]);
            if (velocity_) source.velocity.push_back(cursor_.any_vector(*velocity_, names_));
            if (angular_velocity_) source.angular_velocity.push_back(cursor_.any_vector(*angular_velocity_, names_));
            source.line.push_back(cursor_.line_number());
        }
        source.columns = names_;
        source.facts.emplace_back("columns", fmt::format("{}", fmt::join(names_, " ")));
        return source;
    }

private:
    void next_particle() {
        cursor_.need("a particle");
        cursor_.split();
        if (cursor_.cells().size() == names_.size()) return;
        cursor_.fail(
            fmt::format("the line has {} columns, but {} names {}; make them agree", cursor_.cells().size(),
                        frame_.comment.value("properties").empty() ? "plain XYZ (without Properties=)" : "Properties",
                        names_.size()));
    }

    Frame frame_;
    TextCursor cursor_;
    std::vector<std::string> names_;
    bool allow_size_zero_;
    VectorColumns position_ = {};
    std::optional<VectorColumns> velocity_, angular_velocity_;
    std::optional<SizeColumn> size_;
    std::optional<std::size_t> id_, type_;
};

/// Numbers of the steps that the frames name, or counted.
std::vector<std::int64_t> numbers_of(const std::vector<Frame>& frames) {
    for (const auto* key : {"timestep", "step"}) {
        std::vector<std::int64_t> numbers;
        for (const Frame& frame : frames) {
            if (const auto number = parse_integer(frame.comment.value(key))) numbers.push_back(*number);
        }
        if (numbers.size() == frames.size()) return numbers;
    }
    std::vector<std::int64_t> numbers(frames.size());
    std::iota(numbers.begin(), numbers.end(), std::int64_t{0});
    return numbers;
}

std::vector<double> times_of(const std::vector<Frame>& frames) {
    std::vector<double> times;
    for (const Frame& frame : frames) {
        if (const auto time = parse_number(frame.comment.value("time"))) times.push_back(*time);
    }
    if (times.size() != frames.size()) times.clear();
    return times;
}

bool is_frame_head(TextCursor& line) { return parse_integer(trimmed(line.line())).has_value(); }

/// A line with a word or number for its type, as particles of plain XYZ have, and a position behind it.
bool is_plain_particle(TextCursor& cursor) {
    cursor.split();
    const auto& cells = cursor.cells();
    if (cells.size() < 4) return false;
    return std::all_of(cells.begin() + 1, cells.begin() + 4, [](auto cell) { return parse_number(cell).has_value(); });
}

}  // namespace

bool is_extended_xyz(const Content& content) {
    if (!looks_like_text(content.head())) return false;
    TextCursor cursor({}, content.head());
    if (!cursor.next_filled() || !is_frame_head(cursor) || !cursor.next()) return false;
    if (!parse_xyz_comment(cursor.line()).value("properties").empty()) return true;
    return cursor.next() && is_plain_particle(cursor);
}

Series open_extended_xyz(const Content& content, const ReadOptions& options) {
    TextCursor cursor(content.name(), content.bytes);
    std::vector<Frame> frames;
    Series series;
    scan_steps(series, [&] {
        if (!cursor.next_filled()) return false;
        const std::size_t count = cursor.count("number of particles");
        cursor.need("a comment with Properties=");
        Frame frame{cursor, count, parse_xyz_comment(cursor.line())};
        pass_rows(cursor,
                  {.rows = count,
                   .columns = xyz_columns(frame.comment, cursor).size(),
                   .what = fmt::format("{} particles of the frame {}", count, frames.size())},
                  is_frame_head);
        frames.push_back(std::move(frame));
        series.steps.push_back(0);  // its number depends on the frames behind it
        return true;
    });
    series.steps = numbers_of(frames);
    series.times = times_of(frames);
    series.read = [frames = std::move(frames), steps = series.steps, &options](std::size_t index) {
        Source source = FrameReader(frames[index], options).read();
        source.facts.emplace_back("steps", std::to_string(steps.size()));
        source.facts.emplace_back("step", std::to_string(steps[index]));
        return source;
    };
    return series;
}

}  // namespace recoat
