#pragma once

#include <filesystem>
#include <string_view>

namespace recoat::fuzz {

/// A file that exists in memory only, under a name that other functions can open.
class MemoryFile {
public:
    explicit MemoryFile(std::string_view bytes = {});
    ~MemoryFile();
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    [[nodiscard]] std::filesystem::path path() const;

private:
    int descriptor_;
};

}  // namespace recoat::fuzz
