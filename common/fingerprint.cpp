#include "common/fingerprint.hpp"

#include <array>
#include <fstream>

#include "common/error.hpp"

namespace recoat {

void Fingerprint::add(const char* bytes, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) hash_ = (hash_ ^ static_cast<unsigned char>(bytes[k])) * 0x100000001b3ULL;
}

std::uint64_t fingerprint_of(const std::filesystem::path& file, std::size_t from) {
    std::ifstream stream(file, std::ios::binary);
    Fingerprint fingerprint;
    std::array<char, 1 << 16> buffer;
    stream.seekg(static_cast<std::streamoff>(from));
    while (stream) {
        stream.read(buffer.data(), buffer.size());
        fingerprint.add(buffer.data(), static_cast<std::size_t>(stream.gcount()));
    }
    if (!stream.eof())
        throw InputError(file.string() + ": the file cannot be read; check the path and its permissions");
    return fingerprint.value();
}

}  // namespace recoat
