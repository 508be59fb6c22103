#include <gtest/gtest.h>

#include "analyzer/readers/binary_blocks.hpp"
#include "analyzer/readers/vtk_types.hpp"

namespace recoat {
namespace {

TEST(ByteStream, Base64OfTheStandard) {
    // Test vectors of RFC 4648.
    EXPECT_EQ(ByteStream("Zm9vYmFy", true).take(6), "foobar");
    EXPECT_EQ(ByteStream("Zm9vYmE=", true).take(5), "fooba");
    EXPECT_EQ(ByteStream("Zm9vYg==", true).take(4), "foob");
    EXPECT_EQ(ByteStream("  Zm9v\nYg==\n", true).take(4), "foob");
}

TEST(ByteStream, PartsWithTheirOwnPadding) {
    ByteStream stream("Zm9vYg==Zg==Zm8=", true);
    EXPECT_EQ(stream.take(3), "foo");
    EXPECT_EQ(stream.take(4), "bffo");
    EXPECT_THROW((void)stream.take(1), BlockError);
}

TEST(ByteStream, WhatIsNoBase64) {
    EXPECT_THROW((void)ByteStream("Zm9", true).take(1), BlockError);
    EXPECT_THROW((void)ByteStream("Zm9*", true).take(1), BlockError);
    EXPECT_THROW((void)ByteStream("Zm=v", true).take(1), BlockError);
    EXPECT_THROW((void)ByteStream("Z===", true).take(1), BlockError);
    EXPECT_THROW((void)ByteStream("abc", false).take(4), BlockError);
    EXPECT_EQ(ByteStream("abc", false).take(3), "abc");
}

TEST(BinaryBlocks, LengthsThatDoNotFit) {
    using namespace std::string_literals;
    const auto plain = [](const std::string& bytes) {
        ByteStream stream(bytes, false);
        return read_plain(stream, {4, false}, 4);
    };
    EXPECT_EQ(plain("\4\0\0\0abcd"s), "abcd");
    EXPECT_THROW((void)plain("\5\0\0\0abcde"s), BlockError);
    EXPECT_THROW((void)plain("\4\0\0\0abc"s), BlockError);
    const auto packed = [](const std::string& bytes) {
        ByteStream stream(bytes, false);
        return read_compressed(stream, {4, true}, 4);
    };
    // Blocks, size of a block, size of the last, compressed sizes; then no zlib stream.
    EXPECT_THROW((void)packed("\0\0\0\1\0\0\0\4\0\0\0\0\0\0\0\3abc"s), BlockError);
    EXPECT_THROW((void)packed("\0\0\0\1\0\0\0\5\0\0\0\0\0\0\0\3abc"s), BlockError);
    EXPECT_THROW((void)packed("\0\0\0\2\0\0\0\0\0\0\0\4\0\0\0\3\0\0\0\3abcabc"s), BlockError);
    EXPECT_THROW((void)packed("\377\377\377\377\0\0\0\1\0\0\0\1"s), BlockError);
    EXPECT_THROW((void)packed("\0\0\0\0\0\0\0\0\0\0\0\0"s), BlockError);
}

TEST(VtkTypes, NumbersInBothByteOrders) {
    using namespace std::string_literals;
    EXPECT_EQ(numbers_from("\0\0\x80\x3f\0\0\0\xc0"s, *vtk_type("Float32"), false), (std::vector<double>{1, -2}));
    EXPECT_EQ(numbers_from("\x3f\xf0\0\0\0\0\0\0"s, *vtk_type("double"), true), (std::vector<double>{1}));
    EXPECT_EQ(numbers_from("\xff\xfe"s, *vtk_type("Int16"), true), (std::vector<double>{-2}));
    EXPECT_EQ(numbers_from("\xff\xfe"s, *vtk_type("unsigned_short"), false), (std::vector<double>{65279}));
    EXPECT_EQ(numbers_from("\xff\xff\xff\xff\xff\xff\xff\xff"s, *vtk_type("vtktypeint64"), true),
              (std::vector<double>{-1}));
    EXPECT_FALSE(vtk_type("string"));
}

}  // namespace
}  // namespace recoat
