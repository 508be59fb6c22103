/// The reader RECOAT_FUZZ_READER on any text that it takes for its own.

#include <algorithm>
#include <cstdint>
#include <string>

#include "tests/fuzz/properties.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace recoat;
    static const Reader& reader = *std::ranges::find(readers(), RECOAT_FUZZ_READER, &Reader::name);
    const Content content{.file = "input", .bytes = {reinterpret_cast<const char*>(data), size}, .packed = false};
    fuzz::must_read_or_refuse([&] {
        if (!content.bytes.empty() && reader.recognises(content)) fuzz::check_reader(reader, content);
    });
    return 0;
}
