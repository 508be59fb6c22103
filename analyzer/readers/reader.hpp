#pragma once

#include <filesystem>
#include <span>
#include <string_view>

#include "analyzer/readers/source.hpp"

namespace recoat {

/// One format that particles can be read from. To add a format: a pair of files with these two functions, its test, and
/// a line in the list of reader.cpp.
struct Reader {
    std::string_view name;
    std::string_view description;
    /// Whether the file is of this format, judged by the file and by `head`, its first bytes.
    bool (*recognises)(const std::filesystem::path& file, std::string_view head);
    /// Reads the particles. Throws InputError naming the file, the line and the column at fault.
    Source (*read)(const std::filesystem::path& file, const ColumnNames& columns);
};

/// All formats in the order in which they are tried.
[[nodiscard]] std::span<const Reader> readers();

/// Reads the particles of a file of any known format. Throws InputError when it is of none, or damaged.
[[nodiscard]] Source read_particles(const std::filesystem::path& file, const ColumnNames& columns = {});

}  // namespace recoat
