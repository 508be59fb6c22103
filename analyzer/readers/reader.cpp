#include "analyzer/readers/reader.hpp"

#include <array>
#include <cmath>
#include <fstream>
#include <string>

#include <fmt/format.h>

#include "analyzer/readers/csv.hpp"
#include "analyzer/readers/recoat_state.hpp"
#include "common/error.hpp"

namespace recoat {
namespace {

constexpr std::array<Reader, 2> all_readers = {recoat_state_reader, csv_reader};

std::string read_head(const std::filesystem::path& file) {
    constexpr std::size_t head_size = 4096;
    std::ifstream stream(file, std::ios::binary);
    if (!stream || std::filesystem::is_directory(file)) {
        throw InputError(fmt::format("{}: the file cannot be read; check its name and permissions", file.string()));
    }
    std::string head(head_size, '\0');
    stream.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(stream.gcount()));
    if (head.empty()) throw InputError(fmt::format("{}: the file is empty; give a file of particles", file.string()));
    return head;
}

/// Whatever the format: every particle has a place and a size.
void check_particles(const Source& source, const std::filesystem::path& file) {
    for (std::size_t i = 0; i < source.position.size(); ++i) {
        const Vec3 p = source.position[i];
        const double radius = source.radius[i];
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z) || !std::isfinite(radius) ||
            radius <= 0) {
            throw InputError(
                fmt::format("{}: particle {} has the centre ({}, {}, {}) and the radius {}; all must be finite, the "
                            "radius above zero",
                            file.string(), i, p.x, p.y, p.z, radius));
        }
    }
}

}  // namespace

std::span<const Reader> readers() { return all_readers; }

Source read_particles(const std::filesystem::path& file, const ColumnNames& columns) {
    const std::string head = read_head(file);
    std::string known;
    for (const Reader& reader : all_readers) {
        if (reader.recognises(file, head)) {
            Source source = reader.read(file, columns);
            source.format = reader.name;
            check_particles(source, file);
            return source;
        }
        known += fmt::format("{}{}", known.empty() ? "" : "; ", reader.description);
    }
    throw InputError(fmt::format("{}: the format is not known; known are: {}", file.string(), known));
}

}  // namespace recoat
