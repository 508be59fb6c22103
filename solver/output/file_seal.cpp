#include "solver/output/file_seal.hpp"

#include <fstream>
#include <string>

#include <fmt/format.h>

#include "common/error.hpp"
#include "common/fingerprint.hpp"

namespace recoat {
namespace {

/// The first bytes that the file should have.
std::string expected_seal(const std::filesystem::path& file) {
    std::string text = fmt::format("recoat checkpoint (HDF5 from byte {})\nFNV-1a of what follows: {:016x}\n",
                                   seal_size, fingerprint_of(file, seal_size));
    text.resize(seal_size, '\0');
    return text;
}

}  // namespace

void seal(const std::filesystem::path& file) {
    const std::string text = expected_seal(file);
    std::fstream stream(file, std::ios::binary | std::ios::in | std::ios::out);
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
    stream.close();
    if (!stream) throw InputError(file.string() + ": writing failed; is the disk full?");
}

bool is_intact(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string text(seal_size, '\0');
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    return stream && text == expected_seal(file);
}

}  // namespace recoat
