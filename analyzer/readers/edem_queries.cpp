#include "analyzer/readers/edem_queries.hpp"

#include <algorithm>
#include <cctype>
#include <optional>

#include <fmt/format.h>

#include "analyzer/readers/steps.hpp"
#include "common/number.hpp"
#include "common/tables/header.hpp"
#include "common/tables/text_cursor.hpp"

namespace recoat {
namespace {

constexpr std::string_view time_mark = "TIME:";

/// "Position X (m)" of the line "Q05 : Position X (m):,1,2", or nothing for other lines.
std::optional<std::string> query_name(std::string_view line) {
    std::string_view text = trimmed(line);
    if (!text.starts_with('Q')) return {};
    text.remove_prefix(1);
    const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
    if (digits == 0) return {};
    text = trimmed(text.substr(digits));
    if (!text.starts_with(':')) return {};
    std::string_view name = trimmed(text.substr(1, text.find(',') - 1));
    while (name.ends_with(':')) name = trimmed(name.substr(0, name.size() - 1));
    return std::string(name);
}

/// The queries of one time, each on its line.
struct Queries {
    std::vector<TextCursor> lines;
    std::vector<std::string> names;
};

class QueryReader {
public:
    QueryReader(const Queries& queries, const ReadOptions& options)
        : lines_(queries.lines), header_(queries.names), allow_size_zero_(options.allow_size_zero()) {
        try {
            columns_ = find_particle_columns(header_, options.columns);
            std::vector<std::size_t> lengths(columns_.position.begin(), columns_.position.end());
            if (columns_.size) lengths.push_back(columns_.size->index);
            has_units_ = lengths_have_units(header_, lengths);
        } catch (const ColumnError& error) {
            lines_.front().fail(error.what());
        }
    }

    Source read() {
        Source source;
        source.columns = header_.names();
        source.position = vectors(columns_.position, Dimension::length);
        if (columns_.size) read_sizes(source);
        if (columns_.id) {
            for (std::size_t i = 0; i < count_; ++i) source.id.push_back(line(*columns_.id).integer(i + 1, "id"));
        }
        if (columns_.velocity) source.velocity = vectors(*columns_.velocity, Dimension::speed);
        if (columns_.angular_velocity) {
            source.angular_velocity = vectors(*columns_.angular_velocity, Dimension::angular_velocity);
        }
        if (has_units_) source.own_unit = 1.0;
        return source;
    }

private:
    /// The line of a query, cut, with as many values as the first that was read.
    TextCursor& line(std::size_t query) {
        TextCursor& cursor = lines_[query];
        if (!cursor.cells().empty()) return cursor;
        cursor.split_quoted(',');
        const std::size_t values = cursor.cells().size() - 1;
        if (count_ == 0) count_ = values;
        if (values == count_) return cursor;
        cursor.fail(fmt::format("the query \"{}\" has {} values, but others have {}; export all particles in each",
                                quotable(header_.names()[query]), values, count_));
    }

    [[nodiscard]] double factor(std::size_t query, Dimension dimension) const {
        try {
            return header_.factor(query, dimension);
        } catch (const ColumnError& error) {
            lines_[query].fail(error.what());
        }
    }

    std::vector<Vec3> vectors(const VectorColumns& queries, Dimension dimension) {
        const TextCursor &x = line(queries[0]), &y = line(queries[1]), &z = line(queries[2]);
        const double fx = factor(queries[0], dimension), fy = factor(queries[1], dimension),
                     fz = factor(queries[2], dimension);
        std::vector<Vec3> result;
        for (std::size_t i = 1; i <= count_; ++i) {
            result.push_back({fx * x.number(i, "x"), fy * y.number(i, "y"), fz * z.number(i, "z")});
        }
        return result;
    }

    void read_sizes(Source& source) {
        const std::size_t query = columns_.size->index;
        const TextCursor& cursor = line(query);
        const double to_radius = columns_.size->to_radius * factor(query, Dimension::length);
        for (std::size_t i = 1; i <= count_; ++i) {
            source.radius.push_back(to_radius * cursor.size(i, header_.names()[query], allow_size_zero_));
        }
    }

    std::vector<TextCursor> lines_;
    Header header_;
    bool allow_size_zero_;
    ParticleColumns columns_;
    bool has_units_ = false;
    std::size_t count_ = 0;
};

}  // namespace

bool is_edem_queries(const Content& content) {
    if (!looks_like_text(content.head())) return false;
    TextCursor cursor({}, content.head());
    constexpr int lines_on_top = 10;
    for (int i = 0; i < lines_on_top && cursor.next_filled(); ++i) {
        if (query_name(cursor.line())) return true;
    }
    return false;
}

Series open_edem_queries(const Content& content, const ReadOptions& options) {
    TextCursor cursor(content.name(), content.bytes);
    std::vector<Queries> times(1);
    Series series;
    while (cursor.next_filled()) {
        const std::string_view text = trimmed(cursor.line());
        if (text.starts_with(time_mark)) {
            if (!times.back().names.empty()) times.emplace_back();
            if (const auto time = parse_number(trimmed(text.substr(time_mark.size())))) series.times.push_back(*time);
        } else if (const auto name = query_name(text)) {
            times.back().lines.push_back(cursor);
            times.back().names.push_back(*name);
        }
    }
    cursor.need_line_end();
    if (times.back().names.empty()) times.pop_back();
    for (std::size_t i = 0; i < times.size(); ++i) series.steps.push_back(static_cast<std::int64_t>(i));
    if (series.times.size() != times.size()) series.times.clear();
    series.read = [times = std::move(times), &options](std::size_t index) {
        return QueryReader(times[index], options).read();
    };
    return series;
}

}  // namespace recoat
