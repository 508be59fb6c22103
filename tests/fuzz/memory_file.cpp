#include "tests/fuzz/memory_file.hpp"

#include <string>

#include <sys/mman.h>
#include <unistd.h>

#include "tests/fuzz/properties.hpp"

namespace recoat::fuzz {

MemoryFile::MemoryFile(std::string_view bytes) : descriptor_(memfd_create("input", 0)) {
    require(descriptor_ >= 0, "a file in memory");
    const auto written = write(descriptor_, bytes.data(), bytes.size());
    require(written == static_cast<ssize_t>(bytes.size()), "all bytes in the file");
}

MemoryFile::~MemoryFile() { close(descriptor_); }

std::filesystem::path MemoryFile::path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

}  // namespace recoat::fuzz
