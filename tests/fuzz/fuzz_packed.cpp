/// The layer of packed files: any bytes behind the marks of bzip2, xz and zstd, and bytes that the libraries packed
/// themselves, in members. The first byte says which.

#include <array>
#include <cstdint>
#include <string>

#include "analyzer/readers/packing.hpp"
#include "tests/fuzz/properties.hpp"
#include "tests/support/packed.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace recoat;
    struct Way {
        std::string mark;
        std::string (*pack)(std::string_view);
    };
    static const std::array<Way, 3> ways = {{{"BZh11AY&SY", testing::packed_bzip2},
                                             {std::string("\xfd"
                                                          "7zXZ\0",
                                                          6),
                                              testing::packed_xz},
                                             {"\x28\xb5\x2f\xfd", testing::packed_zstd}}};
    if (size == 0) return 0;
    const Way& way = ways[data[0] % ways.size()];
    const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    const auto unpacked = [](const std::string& packed) { return unpack(*packing_of(packed), packed, "input"); };
    fuzz::must_read_or_refuse([&] { (void)make_content("input", std::string(bytes)); });
    fuzz::must_read_or_refuse([&] { (void)unpacked(way.mark + std::string(bytes)); });
    const std::size_t cut = data[0] % (bytes.size() + 1);
    const std::string members = way.pack(bytes.substr(0, cut)) + std::string(4 * (cut % 3), '\0') +
                                way.pack(bytes.substr(cut)) + std::string(cut % 3, '\0');
    fuzz::require(unpacked(members) == bytes, "packed bytes come back");
    return 0;
}
