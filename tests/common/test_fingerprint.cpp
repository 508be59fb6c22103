#include <cstring>
#include <fstream>

#include <gtest/gtest.h>

#include "common/error.hpp"
#include "common/fingerprint.hpp"
#include "tests/support/temporary_folder.hpp"

namespace recoat {
namespace {

std::uint64_t of(const std::string& text) {
    Fingerprint fingerprint;
    fingerprint.add(text.data(), text.size());
    return fingerprint.value();
}

// Published values of the 64-bit FNV-1a hash.
TEST(Fingerprint, IsFnv1a) {
    EXPECT_EQ(of(""), 0xcbf29ce484222325ULL);
    EXPECT_EQ(of("a"), 0xaf63dc4c8601ec8cULL);
    EXPECT_EQ(of("foobar"), 0x85944171f73967e8ULL);
}

TEST(Fingerprint, OfAFileIsThatOfItsBytes) {
    const testing::TemporaryFolder folder;
    std::string text(200000, 'x');
    for (std::size_t k = 0; k < text.size(); k += 7) text[k] = static_cast<char>(k);
    std::ofstream(folder / "file", std::ios::binary) << text;
    EXPECT_EQ(fingerprint_of(folder / "file"), of(text));
    EXPECT_EQ(fingerprint_of(folder / "file", 512), of(text.substr(512)));
    EXPECT_THROW(fingerprint_of(folder / "none"), InputError);
}

}  // namespace
}  // namespace recoat
