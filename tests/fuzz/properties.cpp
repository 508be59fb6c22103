#include "tests/fuzz/properties.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <string>

#include "analyzer/readers/complete.hpp"
#include "common/error.hpp"

namespace recoat::fuzz {
namespace {

constexpr std::size_t most_steps = 3;           // more of them run the same code
constexpr std::size_t longest_sentence = 1200;  // twenty columns of forty letters quoted

/// Whether a text can be shown as one line.
bool is_sentence(std::string_view text) {
    return !text.empty() && text.size() < longest_sentence &&
           std::ranges::all_of(text, [](unsigned char c) { return c >= ' ' && c < 0x7f; });
}

/// Options as few users give them all at once.
ReadOptions unusual_options() {
    ReadOptions options;
    options.columns = {.x = "y", .y = "x", .z = {}, .radius = {}, .diameter = "mass"};
    options.length_unit = 1e-6;
    options.types_left_out = {"2"};
    options.leave_out_size_zero = true;
    return options;
}

ReadOptions radius_of_types() {
    ReadOptions options;
    options.radius_of_type = {{"1", 1e-3}, {"2", 2e-3}};
    options.types = {"1"};
    return options;
}

ReadOptions constant_radius() {
    ReadOptions options;
    options.radius = 1e-3;
    return options;
}

}  // namespace

void require(bool holds, std::string_view what) {
    if (holds) return;
    std::fprintf(stderr, "property does not hold: %.*s\n", static_cast<int>(what.size()), what.data());
    std::abort();
}

void must_read_or_refuse(const std::function<void()>& read) {
    try {
        read();
    } catch (const InputError& error) {
        const std::string_view sentence = error.what();
        require(is_sentence(sentence), sentence);
    }
}

void check_source(const Source& source) {
    const std::size_t count = source.position.size();
    require(source.radius.size() == count, "a radius for every particle");
    require(source.id.empty() || source.id.size() == count, "identities for all or none");
    require(source.line.empty() || source.line.size() == count, "lines for all or none");
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 p = source.position[i];
        require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z), "finite positions");
        require(std::isfinite(source.radius[i]) && source.radius[i] > 0, "finite radii above zero");
    }
    for (const auto* vectors : {&source.velocity, &source.angular_velocity}) {
        require(vectors->empty() || vectors->size() == count, "velocities for all or none");
        const auto finite = [](Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); };
        require(std::ranges::all_of(*vectors, finite), "finite velocities");
    }
    for (const std::string& warning : source.warnings) require(is_sentence(warning), warning);
    require(source.type.of.empty() || source.type.of.size() == count, "types for all or none");
    const auto named = [&](std::uint32_t type) { return type < source.type.names.size(); };
    require(std::ranges::all_of(source.type.of, named), "a name for every type");
    require(std::set(source.id.begin(), source.id.end()).size() == source.id.size(), "every identity once");
}

void check_reader(const Reader& reader, const Content& content) {
    for (const ReadOptions& options : {ReadOptions{}, unusual_options(), constant_radius(), radius_of_types()}) {
        must_read_or_refuse([&] {
            const Series series = reader.open(content, options);
            require(!series.steps.empty(), "a time step at least");
            for (std::size_t i = 0; i < std::min(most_steps, series.steps.size()); ++i) {
                Source source = series.read(i);
                complete(source, content.name(), options);
                check_source(source);
            }
        });
    }
}

}  // namespace recoat::fuzz
