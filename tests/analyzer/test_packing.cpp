/// Files packed with bzip2, xz and zstd, made by the libraries themselves; gzip has a test of its own.

#include "analyzer/readers/packing.hpp"
#include "analyzer/readers/unpacking.hpp"
#include "tests/analyzer/reader_fixture.hpp"
#include "tests/support/packed.hpp"

namespace recoat {
namespace {

using testing::begins;

struct Packer {
    std::string name;
    std::string (*pack)(std::string_view);
};

class Packed : public testing::ReaderTest, public ::testing::WithParamInterface<Packer> {};

TEST_P(Packed, MembersAndPadding) {
    const auto pack = GetParam().pack;
    const auto unpacked = [](const std::string& bytes) {
        const Packing* packing = packing_of(bytes);
        return packing == nullptr ? "not packed" : unpack(*packing, bytes, "layer");
    };
    const std::string large(3'000'000, 'x');  // far more than the room it begins with
    EXPECT_EQ(packing_of(pack("one"))->name, GetParam().name);
    EXPECT_EQ(unpacked(pack(large)), large);
    EXPECT_EQ(unpacked(pack("one") + pack("") + pack("two")), "onetwo");
    EXPECT_EQ(unpacked(pack("one") + std::string(8, '\0') + pack("two") + std::string(4, '\0')), "onetwo");
    EXPECT_EQ(read(pack("x,y,z,r\n1,2,3,1\n")).position[0], (Vec3{1, 2, 3}));
}

TEST_P(Packed, DamagedFiles) {
    const auto pack = GetParam().pack;
    const std::string whole = pack("x,y,z,r\n1,2,3,1\n4,5,6,1\n");
    for (std::size_t size = 10; size < whole.size(); ++size) {
        EXPECT_TRUE(
            begins(error(whole.substr(0, size)), "layer: the compressed data are damaged or end too early (end"))
            << size;
    }
    std::string changed = whole;
    changed[whole.size() / 2] = static_cast<char>(changed[whole.size() / 2] ^ 0x55);
    EXPECT_TRUE(begins(error(changed), "layer: ")) << error(changed);
    EXPECT_TRUE(begins(error(whole + "x,y"), "layer: the compressed data are damaged or end too early (something els"));
    EXPECT_EQ(error(pack("")), "layer: the file is empty; give a file of particles");
    EXPECT_TRUE(begins(error(pack("\x89HDF\r\n\x1a\n")),
                       "layer: HDF5 files cannot be read while packed with " + GetParam().name));
    EXPECT_TRUE(begins(error(pack(std::string(20'000'000, 'x'))),
                       "layer: the compressed data are damaged or end too early (they unpack to more than a thousand"));
}

INSTANTIATE_TEST_SUITE_P(All, Packed,
                         ::testing::Values(Packer{"bzip2", testing::packed_bzip2}, Packer{"xz", testing::packed_xz},
                                           Packer{"zstd", testing::packed_zstd}),
                         [](const auto& packer) { return packer.param.name; });

TEST(Packing, FramesThatZstdPassesOver) {
    const std::string skipped("\x50\x2a\x4d\x18\x04\0\0\0note", 12);
    const std::string bytes = skipped + testing::packed_zstd("one") + skipped + testing::packed_zstd("two");
    EXPECT_EQ(unpack(*packing_of(bytes), bytes, "layer"), "onetwo");
}

}  // namespace
}  // namespace recoat
