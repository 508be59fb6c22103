#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <bzlib.h>
#include <lzma.h>
#include <zlib.h>
#include <zstd.h>

namespace recoat::testing {

/// One gzip member, packed by zlib.
inline std::string packed(std::string_view bytes, int level = Z_BEST_COMPRESSION) {
    z_stream stream = {};
    deflateInit2(&stream, level, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
    std::string result(deflateBound(&stream, bytes.size()), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(result.data());
    stream.avail_out = static_cast<uInt>(result.size());
    deflate(&stream, Z_FINISH);
    result.resize(stream.total_out);
    deflateEnd(&stream);
    return result;
}

inline std::string packed_bzip2(std::string_view bytes) {
    std::string result(bytes.size() + bytes.size() / 100 + 600, '\0');
    auto size = static_cast<unsigned>(result.size());
    BZ2_bzBuffToBuffCompress(result.data(), &size, const_cast<char*>(bytes.data()), static_cast<unsigned>(bytes.size()),
                             1, 0, 0);
    result.resize(size);
    return result;
}

inline std::string packed_xz(std::string_view bytes) {
    std::string result(lzma_stream_buffer_bound(bytes.size()), '\0');
    std::size_t size = 0;
    lzma_easy_buffer_encode(0, LZMA_CHECK_CRC64, nullptr, reinterpret_cast<const std::uint8_t*>(bytes.data()),
                            bytes.size(), reinterpret_cast<std::uint8_t*>(result.data()), &size, result.size());
    result.resize(size);
    return result;
}

inline std::string packed_zstd(std::string_view bytes) {
    std::string result(ZSTD_compressBound(bytes.size()), '\0');
    ZSTD_CCtx* context = ZSTD_createCCtx();
    ZSTD_CCtx_setParameter(context, ZSTD_c_checksumFlag, 1);  // as the program zstd does
    result.resize(ZSTD_compress2(context, result.data(), result.size(), bytes.data(), bytes.size()));
    ZSTD_freeCCtx(context);
    return result;
}

}  // namespace recoat::testing
