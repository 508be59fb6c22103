#include <gtest/gtest.h>

#include "common/text_encoding.hpp"

namespace recoat {
namespace {

using namespace std::string_view_literals;

TEST(TextEncoding, AByteOrderMarkIsNoText) {
    EXPECT_EQ(without_byte_order_mark("\xEF\xBB\xBFx,y"), "x,y");
    EXPECT_EQ(without_byte_order_mark("x,y"), "x,y");
    EXPECT_EQ(without_byte_order_mark(""), "");
}

TEST(TextEncoding, WideEncodingsAreNamed) {
    EXPECT_EQ(wide_encoding("\xFF\xFEx\0,\0y\0"sv), "UTF-16");
    EXPECT_EQ(wide_encoding("\xFE\xFF\0x\0,\0y"sv), "UTF-16");
    EXPECT_EQ(wide_encoding("I\0T\0E\0M\0"sv), "UTF-16");
    EXPECT_EQ(wide_encoding("\0I\0T\0E\0M"sv), "UTF-16");
    EXPECT_EQ(wide_encoding("\xFF\xFE\0\0x\0\0\0"sv), "UTF-32");
    EXPECT_EQ(wide_encoding("x\0\0\0,\0\0\0y\0\0\0,\0\0\0"sv), "UTF-32");
    for (const std::string_view other :
         {"x,y,z"sv, "\xEF\xBB\xBFx"sv, "\x89HDF\r\n\x1a\n"sv, "\0\0\0\0\0\0\0\0"sv, ""sv}) {
        EXPECT_EQ(wide_encoding(other), "") << other;
    }
}

TEST(TextEncoding, WhatIsNotUtf8IsLatin1) {
    EXPECT_EQ(in_utf8("x [\xB5m]"), "x [\u00B5m]");
    EXPECT_EQ(in_utf8("x [\u03BCm]"), "x [\u03BCm]");
    EXPECT_EQ(in_utf8("\xE9\xFF"), "\u00E9\u00FF");
    EXPECT_EQ(in_utf8("plain"), "plain");
    EXPECT_EQ(in_utf8("cut \xE2\x82"), "cut \u00E2\u0082");
}

}  // namespace
}  // namespace recoat
