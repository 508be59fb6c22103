#include "analyzer/readers/gzip.hpp"

#include <algorithm>
#include <new>

// Input is not written to.
#define ZLIB_CONST
#include <zlib.h>

#include "analyzer/readers/unpacking.hpp"

namespace recoat {
namespace {

constexpr std::size_t largest_piece = std::size_t{1} << 30;  // zlib counts in 32 bits
constexpr int window_of_gzip = 15 + 16;

class Stream {
public:
    Stream() {
        if (inflateInit2(&stream_, window_of_gzip) != Z_OK) throw std::bad_alloc();
    }
    ~Stream() { inflateEnd(&stream_); }
    Stream(const Stream&) = delete;
    Stream& operator=(const Stream&) = delete;

    static bool begins(std::string_view bytes) { return is_gzip(bytes); }
    void next() { inflateReset(&stream_); }

    UnpackedPiece step(std::string_view packed, char* place, std::size_t room) {
        const std::size_t piece = std::min(packed.size(), largest_piece), space = std::min(room, largest_piece);
        stream_.next_in = reinterpret_cast<const Bytef*>(packed.data());
        stream_.avail_in = static_cast<uInt>(piece);
        stream_.next_out = reinterpret_cast<Bytef*>(place);
        stream_.avail_out = static_cast<uInt>(space);
        const int status = inflate(&stream_, Z_NO_FLUSH);
        if (status != Z_OK && status != Z_STREAM_END && status != Z_BUF_ERROR) {
            throw PackingError(stream_.msg != nullptr ? stream_.msg : "no valid block");
        }
        return {piece - stream_.avail_in, space - stream_.avail_out, status == Z_STREAM_END};
    }

private:
    z_stream stream_ = {};
};

}  // namespace

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"); }

std::string unpack_gzip(std::string_view packed) { return unpack_members<Stream>(packed); }

}  // namespace recoat
