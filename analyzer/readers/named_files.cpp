#include "analyzer/readers/named_files.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>

#include <fmt/format.h>

#include "analyzer/readers/reader.hpp"
#include "common/error.hpp"
#include "common/number.hpp"
#include "common/tables/text_cursor.hpp"

namespace recoat {
namespace {

Source read_one(const Content& content, const NamedFile& file, const ReadOptions& options,
                bool (*allowed)(const Content& named)) {
    try {
        if (std::ranges::any_of(file.name, [](unsigned char c) { return std::iscntrl(c) != 0; })) {
            throw InputError(
                fmt::format("the name \"{}\" of a file has control characters; rename it", quotable(file.name)));
        }
        const Content named = content.load(content.file.parent_path() / file.name);
        if (!allowed(named)) throw InputError(named.name() + ": the file names files itself; name those instead");
        const Series series = open_series(named, options);
        if (series.steps.size() != 1 || !series.damage.empty()) {
            throw InputError(fmt::format("{}: the file holds {} time steps, but stands for one; give the file itself",
                                         named.name(), series.steps.size()));
        }
        return series.read(0);
    } catch (const InputError& error) {
        throw InputError(fmt::format("{} (it is named in {})", error.what(), file.place));
    }
}

template <class Value>
void append(std::vector<Value>& values, const std::vector<Value>& more) {
    values.insert(values.end(), more.begin(), more.end());
}

/// Whether a piece says the same things of its particles as those before it.
bool alike(const Source& one, const Source& other) {
    return one.radius.empty() == other.radius.empty() && one.velocity.empty() == other.velocity.empty() &&
           one.angular_velocity.empty() == other.angular_velocity.empty() && one.id.empty() == other.id.empty() &&
           one.type.of.empty() == other.type.of.empty() && one.own_unit == other.own_unit &&
           one.time_unit == other.time_unit;
}

void add(Source& all, const Source& piece) {
    append(all.position, piece.position);
    append(all.radius, piece.radius);
    append(all.velocity, piece.velocity);
    append(all.angular_velocity, piece.angular_velocity);
    append(all.id, piece.id);
    for (const std::uint32_t type : piece.type.of) all.type.add(piece.type.names[type]);
}

}  // namespace

Source read_named_files(const Content& content, const NamedStep& step, const ReadOptions& options,
                        bool (*allowed)(const Content& named)) {
    Source all;
    for (const NamedFile& file : step.files) {
        Source piece = read_one(content, file, options, allowed);
        if (piece.position.empty()) continue;
        if (all.position.empty()) {
            all = std::move(piece);
            continue;
        }
        if (!alike(all, piece)) {
            throw InputError(
                fmt::format("{}: the file {} says other things of its particles than those before it (size, identity, "
                            "velocity, type); give pieces with the same arrays",
                            file.place, quotable(file.name)));
        }
        add(all, piece);
    }
    all.line.clear();  // of one file each
    return all;
}

Series named_series(const Content& content, std::vector<NamedStep> steps, const ReadOptions& options,
                    bool (*allowed)(const Content& named)) {
    Series series;
    series.steps.resize(steps.size());
    std::iota(series.steps.begin(), series.steps.end(), std::int64_t{0});
    for (const NamedStep& step : steps) series.times.push_back(step.time);
    series.read = [&content, &options, allowed, steps = std::move(steps)](std::size_t index) {
        Source source = read_named_files(content, steps[index], options, allowed);
        source.facts.emplace_back("steps", std::to_string(steps.size()));
        source.facts.emplace_back("step", std::to_string(index));
        source.facts.emplace_back("time", shortest(steps[index].time));
        source.facts.emplace_back("files", std::to_string(steps[index].files.size()));
        return source;
    };
    return series;
}

}  // namespace recoat
