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

/// Options as few users give them all at once.
ReadOptions unusual_options() {
    ReadOptions options;
    options.columns = {.x = "y", .y = "x", .z = {}, .radius = {}, .diameter = "mass"};
    options.length_unit = 1e-6;
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
        require(!sentence.empty() && sentence.size() < longest_sentence, sentence);
        require(std::ranges::all_of(sentence, [](unsigned char c) { return c >= ' ' && c < 0x7f; }), sentence);
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
    require(std::set(source.id.begin(), source.id.end()).size() == source.id.size(), "every identity once");
}

void check_reader(const Reader& reader, const Content& content) {
    for (const ReadOptions& options : {ReadOptions{}, unusual_options(), constant_radius()}) {
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
