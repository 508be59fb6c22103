#include "analyzer/readers/xz.hpp"

#include <cstdint>
#include <new>

#include <lzma.h>

#include "analyzer/readers/unpacking.hpp"

namespace recoat {
namespace {

constexpr std::string_view magic(
    "\xfd"
    "7zXZ\0",
    6);
constexpr std::uint64_t most_memory = std::uint64_t{192} << 20;  // xz -9 needs 65 MiB

class Stream {
public:
    Stream() { next(); }
    ~Stream() { lzma_end(&stream_); }
    Stream(const Stream&) = delete;
    Stream& operator=(const Stream&) = delete;

    static bool begins(std::string_view bytes) { return is_xz(bytes); }

    void next() {
        if (lzma_stream_decoder(&stream_, most_memory, 0) != LZMA_OK) throw std::bad_alloc();
    }

    UnpackedPiece step(std::string_view packed, char* place, std::size_t room) {
        stream_.next_in = reinterpret_cast<const std::uint8_t*>(packed.data());
        stream_.avail_in = packed.size();
        stream_.next_out = reinterpret_cast<std::uint8_t*>(place);
        stream_.avail_out = room;
        const lzma_ret status = lzma_code(&stream_, LZMA_RUN);
        if (status == LZMA_MEM_ERROR) throw std::bad_alloc();
        if (status == LZMA_MEMLIMIT_ERROR) throw PackingError("they ask for more memory than xz -9");
        if (status == LZMA_OPTIONS_ERROR) throw PackingError("they are packed in a way that is not known");
        if (status != LZMA_OK && status != LZMA_STREAM_END && status != LZMA_BUF_ERROR) {
            throw PackingError("no valid block");
        }
        return {packed.size() - stream_.avail_in, room - stream_.avail_out, status == LZMA_STREAM_END};
    }

private:
    lzma_stream stream_ = LZMA_STREAM_INIT;
};

}  // namespace

bool is_xz(std::string_view bytes) { return bytes.starts_with(magic); }

std::string unpack_xz(std::string_view packed) { return unpack_members<Stream>(packed); }

}  // namespace recoat
