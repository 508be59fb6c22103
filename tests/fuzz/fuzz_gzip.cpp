/// The gzip layer: any bytes behind the two that mark a gzip file, and bytes that zlib packed itself, in members.

#include <cstdint>
#include <string>

#include <zlib.h>

#include "analyzer/readers/gzip.hpp"
#include "tests/fuzz/properties.hpp"

namespace {

std::string packed(std::string_view bytes) {
    z_stream stream = {};
    deflateInit2(&stream, 1, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
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

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace recoat;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    fuzz::must_read_or_refuse([&] { (void)make_content("input", std::string(bytes)); });
    fuzz::must_read_or_refuse([&] { (void)unpack_gzip("\x1f\x8b" + std::string(bytes), "input"); });
    // The first byte says where one member ends and the next begins.
    const std::size_t cut = size == 0 ? 0 : data[0] % (size + 1);
    const std::string members = packed(bytes.substr(0, cut)) + packed(bytes.substr(cut)) + std::string(cut % 3, '\0');
    fuzz::require(unpack_gzip(members, "input") == bytes, "packed bytes come back");
    return 0;
}
