#include "analyzer/readers/zstd.hpp"

#include <memory>
#include <new>

#include <zstd.h>

#include "analyzer/readers/unpacking.hpp"

namespace recoat {
namespace {

struct FreeStream {
    void operator()(ZSTD_DCtx* stream) const { ZSTD_freeDCtx(stream); }
};

class Stream {
public:
    Stream() : stream_(ZSTD_createDCtx()) {
        if (stream_ == nullptr) throw std::bad_alloc();
    }

    static bool begins(std::string_view bytes) { return is_zstd(bytes); }
    void next() { ZSTD_DCtx_reset(stream_.get(), ZSTD_reset_session_only); }

    UnpackedPiece step(std::string_view packed, char* place, std::size_t room) {
        ZSTD_inBuffer in = {packed.data(), packed.size(), 0};
        ZSTD_outBuffer out = {place, room, 0};
        const std::size_t status = ZSTD_decompressStream(stream_.get(), &out, &in);
        if (ZSTD_isError(status) != 0) throw PackingError(ZSTD_getErrorName(status));
        return {in.pos, out.pos, status == 0};
    }

private:
    std::unique_ptr<ZSTD_DCtx, FreeStream> stream_;
};

}  // namespace

bool is_zstd(std::string_view bytes) {
    if (bytes.size() < 4) return false;
    const bool passed_over = (bytes[0] & 0xf0) == 0x50 && bytes.substr(1, 3) == "\x2a\x4d\x18";
    return passed_over || bytes.starts_with("\x28\xb5\x2f\xfd");
}

std::string unpack_zstd(std::string_view packed) { return unpack_members<Stream>(packed); }

}  // namespace recoat
