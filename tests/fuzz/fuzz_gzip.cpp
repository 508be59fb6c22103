/// The gzip layer: any bytes behind the two that mark a gzip file, and bytes that zlib packed itself, in members.

#include <cstdint>
#include <string>

#include "analyzer/readers/packing.hpp"
#include "tests/fuzz/properties.hpp"
#include "tests/support/packed.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace recoat;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const auto unpacked = [](const std::string& packed) { return unpack(*packing_of(packed), packed, "input"); };
    fuzz::must_read_or_refuse([&] { (void)make_content("input", std::string(bytes)); });
    fuzz::must_read_or_refuse([&] { (void)unpacked("\x1f\x8b" + std::string(bytes)); });
    // The first byte says where one member ends and the next begins.
    const std::size_t cut = size == 0 ? 0 : data[0] % (size + 1);
    const std::string members =
        testing::packed(bytes.substr(0, cut), 1) + testing::packed(bytes.substr(cut), 1) + std::string(cut % 3, '\0');
    fuzz::require(unpacked(members) == bytes, "packed bytes come back");
    return 0;
}
