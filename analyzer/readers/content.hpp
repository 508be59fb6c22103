#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace recoat {

/// A file of particles as the readers get it.
struct Content {
    std::filesystem::path file;
    std::string bytes;    ///< all of it, unpacked if it was a gzip file; of HDF5 files only the first bytes
    bool packed = false;  ///< whether it was a gzip file

    [[nodiscard]] std::string name() const { return file.string(); }
    /// The first bytes, enough to recognise a format by.
    [[nodiscard]] std::string_view head() const { return std::string_view(bytes).substr(0, 4096); }
    /// Whether it begins like an HDF5 file, or has that beginning behind a block of up to 2048 bytes.
    [[nodiscard]] bool is_hdf5() const;
};

/// Loads a file. Throws InputError when it cannot be read, is empty or a damaged gzip file.
[[nodiscard]] Content load_content(const std::filesystem::path& file);

/// The content of a file that has these bytes. Throws InputError when there are none or they are a damaged gzip file.
[[nodiscard]] Content make_content(const std::filesystem::path& file, std::string bytes);

}  // namespace recoat
