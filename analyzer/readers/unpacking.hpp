#pragma once

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace recoat {

/// Packed bytes are not as they should be; the message is the reason, for a sentence in brackets.
struct PackingError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// What one call of a library that unpacks did.
struct UnpackedPiece {
    std::size_t taken = 0, made = 0;  ///< bytes
    bool ended = false;               ///< whether a member of the file ended with it
};

/// Size up to which a packed file is unpacked: tables pack to a tenth or less, but never as densely as bytes made to
/// fill the memory.
inline std::size_t largest_unpacked(std::size_t packed) {
    constexpr std::size_t largest_ratio = 1032, always = std::size_t{1} << 24;
    return std::max(always, packed > std::string::npos / largest_ratio ? packed : largest_ratio * packed);
}

/// Unpacks all members of a file, one after the other; zeros may follow each. `Stream` wraps a library:
///   static bool begins(std::string_view): whether a member begins here,
///   UnpackedPiece step(std::string_view packed, char* place, std::size_t room),
///   void next(): makes it ready for another member.
/// Throws PackingError.
template <class Stream>
std::string unpack_members(std::string_view packed) {
    constexpr std::size_t usual_ratio = 4, least = 1024;
    const std::size_t largest = largest_unpacked(packed.size());
    std::string bytes(std::max(least, std::min(usual_ratio * packed.size(), largest)), '\0');
    std::size_t size = 0;
    Stream stream;
    while (true) {
        if (size == bytes.size()) {
            if (size >= largest) throw PackingError("they unpack to more than a thousand times their size");
            bytes.resize(std::min(2 * size, largest));
        }
        const UnpackedPiece piece = stream.step(packed, bytes.data() + size, bytes.size() - size);
        packed.remove_prefix(piece.taken);
        size += piece.made;
        if (!piece.ended) {
            // Room was left, so it was the bytes that gave out.
            if (packed.empty() && size < bytes.size()) throw PackingError("end of the file");
            continue;
        }
        packed.remove_prefix(std::min(packed.find_first_not_of('\0'), packed.size()));
        if (packed.empty()) break;
        if (!Stream::begins(packed)) throw PackingError("something else follows them");
        stream.next();
    }
    bytes.resize(size);
    return bytes;
}

}  // namespace recoat
