#pragma once

#include <cstddef>
#include <filesystem>

namespace recoat {

/// Bytes at the start of a file that HDF5 leaves to its user; they hold the seal.
inline constexpr std::size_t seal_size = 512;

/// Writes the fingerprint of everything behind them into the first `seal_size` bytes of a finished file. Throws
/// InputError when that fails.
void seal(const std::filesystem::path& file);

/// Whether the file is as it was sealed, to the bit, seal included.
bool is_intact(const std::filesystem::path& file);

}  // namespace recoat
