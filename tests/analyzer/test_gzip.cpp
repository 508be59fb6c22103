#include "analyzer/readers/gzip.hpp"
#include "tests/analyzer/reader_fixture.hpp"
#include "tests/support/packed.hpp"

namespace recoat {
namespace {

using testing::begins;
using testing::packed;

class Gzip : public testing::ReaderTest {};

TEST_F(Gzip, MembersAndPadding) {
    const std::string large(3'000'000, 'x');  // far more than the room it begins with
    EXPECT_EQ(unpack_gzip(packed(large)), large);
    EXPECT_EQ(unpack_gzip(packed("one") + packed("") + packed("two")), "onetwo");
    EXPECT_EQ(unpack_gzip(packed("one") + std::string(5, '\0')), "one");
    EXPECT_EQ(read(packed("x,y,z,r\n1,2,3,1\n")).position[0], (Vec3{1, 2, 3}));
}

TEST_F(Gzip, DamagedFiles) {
    const std::string whole = packed("x,y,z,r\n1,2,3,1\n4,5,6,1\n");
    for (std::size_t size = 2; size < whole.size(); ++size) {
        EXPECT_TRUE(
            begins(error(whole.substr(0, size)), "layer: the compressed data are damaged or end too early (end"))
            << size;
    }
    std::string wrong_sum = whole;
    wrong_sum[whole.size() - 6] ^= 1;
    EXPECT_TRUE(begins(error(wrong_sum), "layer: the compressed data are damaged or end too early (incorrect data ch"));
    EXPECT_TRUE(begins(error(whole + "x,y"), "layer: the compressed data are damaged or end too early (something els"));
    EXPECT_EQ(error(packed("")), "layer: the file is empty; give a file of particles");
    EXPECT_EQ(error(packed(packed("x,y,z,r\n1,2,3,1\n"))),
              "layer: the file is packed twice, with gzip inside of gzip; unpack it once");
    EXPECT_TRUE(begins(error(packed("\x89HDF\r\n\x1a\n")), "layer: HDF5 files cannot be read while packed with gzip"));
}

}  // namespace
}  // namespace recoat
