#include "common/text_encoding.hpp"

#include <algorithm>
#include <cstddef>

namespace recoat {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

bool is_ascii(char c) { return static_cast<unsigned char>(c) < 0x80; }

/// Length of the sequence that this first byte announces; 0: none.
std::size_t announced_length(unsigned char first) {
    if (first < 0x80) return 1;
    if (first >= 0xC2 && first < 0xE0) return 2;
    if (first >= 0xE0 && first < 0xF0) return 3;
    if (first >= 0xF0 && first < 0xF5) return 4;
    return 0;
}

bool is_utf8(std::string_view text) {
    while (!text.empty()) {
        const std::size_t length = announced_length(static_cast<unsigned char>(text.front()));
        if (length == 0 || length > text.size()) return false;
        const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; };
        if (!std::ranges::all_of(text.substr(1, length - 1), continues)) return false;
        text.remove_prefix(length);
    }
    return true;
}

/// Whether the first letters of the text are ASCII, each in so many bytes with zeros around it.
bool is_spread_out(std::string_view bytes, std::size_t width) {
    constexpr std::size_t letters = 4;
    if (bytes.size() < letters * width) return false;
    for (const std::size_t place : {std::size_t{0}, width - 1}) {
        bool spread = true;
        for (std::size_t i = 0; i < letters * width; ++i) {
            const bool zero = bytes[i] == '\0';
            spread = spread && (i % width == place ? !zero && is_ascii(bytes[i]) : zero);
        }
        if (spread) return true;
    }
    return false;
}

}  // namespace

std::string_view without_byte_order_mark(std::string_view bytes) {
    if (bytes.starts_with(byte_order_mark)) bytes.remove_prefix(byte_order_mark.size());
    return bytes;
}

std::string_view wide_encoding(std::string_view bytes) {
    using namespace std::string_view_literals;
    for (const std::string_view mark : {"\xFF\xFE\0\0"sv, "\0\0\xFE\xFF"sv}) {
        if (bytes.starts_with(mark)) return "UTF-32";
    }
    for (const std::string_view mark : {"\xFF\xFE"sv, "\xFE\xFF"sv}) {
        if (bytes.starts_with(mark)) return "UTF-16";
    }
    if (is_spread_out(bytes, 4)) return "UTF-32";
    return is_spread_out(bytes, 2) ? "UTF-16" : "";
}

std::string wide_text_problem(std::string_view bytes) {
    const std::string encoding(wide_encoding(bytes));
    if (encoding.empty()) return {};
    return "the file is text in " + encoding + ", which is not read; save it as UTF-8 (in an editor, or by iconv -f " +
           encoding + " -t UTF-8)";
}

std::string in_utf8(std::string_view text) {
    if (is_utf8(text)) return std::string(text);
    std::string result;
    for (const char c : text) {
        if (is_ascii(c)) {
            result += c;
        } else {
            const auto code = static_cast<unsigned char>(c);
            result += static_cast<char>(0xC0 | (code >> 6));
            result += static_cast<char>(0x80 | (code & 0x3F));
        }
    }
    return result;
}

}  // namespace recoat
