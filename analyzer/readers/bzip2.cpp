#include "analyzer/readers/bzip2.hpp"

#include <algorithm>
#include <new>

#include <bzlib.h>

#include "analyzer/readers/unpacking.hpp"

namespace recoat {
namespace {

constexpr std::size_t largest_piece = std::size_t{1} << 30;  // the library counts in 32 bits

class Stream {
public:
    Stream() { begin(); }
    ~Stream() { BZ2_bzDecompressEnd(&stream_); }
    Stream(const Stream&) = delete;
    Stream& operator=(const Stream&) = delete;

    static bool begins(std::string_view bytes) { return is_bzip2(bytes); }

    void next() {
        BZ2_bzDecompressEnd(&stream_);
        begin();
    }

    UnpackedPiece step(std::string_view packed, char* place, std::size_t room) {
        const std::size_t piece = std::min(packed.size(), largest_piece), space = std::min(room, largest_piece);
        stream_.next_in = const_cast<char*>(packed.data());  // the library does not write to it
        stream_.avail_in = static_cast<unsigned>(piece);
        stream_.next_out = place;
        stream_.avail_out = static_cast<unsigned>(space);
        const int status = BZ2_bzDecompress(&stream_);
        if (status == BZ_MEM_ERROR) throw std::bad_alloc();
        if (status != BZ_OK && status != BZ_STREAM_END) throw PackingError("no valid block");
        return {piece - stream_.avail_in, space - stream_.avail_out, status == BZ_STREAM_END};
    }

private:
    void begin() {
        stream_ = {};
        if (BZ2_bzDecompressInit(&stream_, 0, 0) != BZ_OK) throw std::bad_alloc();
    }

    bz_stream stream_ = {};
};

}  // namespace

bool is_bzip2(std::string_view bytes) {
    // "BZh", the size of a block from 1 to 9, and the mark of a block or of the end.
    if (bytes.size() < 10 || !bytes.starts_with("BZh") || bytes[3] < '1' || bytes[3] > '9') return false;
    const std::string_view mark = bytes.substr(4, 6);
    return mark == "1AY&SY" || mark == "\x17\x72\x45\x38\x50\x90";
}

std::string unpack_bzip2(std::string_view packed) { return unpack_members<Stream>(packed); }

}  // namespace recoat
