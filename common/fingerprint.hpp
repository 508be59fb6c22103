#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace recoat {

/// FNV-1a hash of bytes. Every step is one-to-one, so a change of a single byte always changes the result; any other
/// damage does but for one chance in 2^64.
class Fingerprint {
public:
    void add(const char* bytes, std::size_t count);
    [[nodiscard]] std::uint64_t value() const { return hash_; }

private:
    std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};

/// That of a file from byte `from` to its end. Throws InputError when the file cannot be read.
std::uint64_t fingerprint_of(const std::filesystem::path& file, std::size_t from = 0);

}  // namespace recoat
