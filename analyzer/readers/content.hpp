#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace recoat {

struct Content;

/// Loads a file. Throws InputError when it cannot be read, is empty or damaged while packed.
[[nodiscard]] Content load_content(const std::filesystem::path& file);

/// A file of particles as the readers get it.
struct Content {
    std::filesystem::path file;
    std::string bytes;    ///< all of it, unpacked if it was packed; of HDF5 files only the first bytes
    bool packed = false;  ///< whether it was packed with gzip, bzip2, xz or zstd
    /// How files are loaded that this one names.
    Content (*load)(const std::filesystem::path& file) = load_content;

    [[nodiscard]] std::string name() const { return file.string(); }
    /// The first bytes, enough to recognise a format by.
    [[nodiscard]] std::string_view head() const { return std::string_view(bytes).substr(0, 4096); }
    /// Whether it begins like an HDF5 file, or has that beginning behind a block of up to 2048 bytes.
    [[nodiscard]] bool is_hdf5() const;
};

/// The content of a file that has these bytes. Throws InputError as load_content does.
[[nodiscard]] Content make_content(const std::filesystem::path& file, std::string bytes);

}  // namespace recoat
