#pragma once

#include <filesystem>
#include <span>
#include <string_view>

#include "analyzer/readers/content.hpp"
#include "analyzer/readers/source.hpp"

namespace recoat {

/// One format that particles can be read from. To add a format: a pair of files with these two functions, its test, and
/// a line in the list of reader.cpp.
struct Reader {
    std::string_view name;
    std::string_view description;
    /// Whether the file is of this format, judged by what it holds.
    bool (*recognises)(const Content& content);
    /// Reads the particles, lengths in the unit of the file. Throws InputError naming the file, the line and the column
    /// at fault.
    Source (*read)(const Content& content, const ReadOptions& options);
};

/// All formats in the order in which they are tried.
[[nodiscard]] std::span<const Reader> readers();

/// Reads the particles of a file of any known format. Throws InputError when it is of none, or damaged.
[[nodiscard]] Source read_particles(const std::filesystem::path& file, const ReadOptions& options = {});

}  // namespace recoat
