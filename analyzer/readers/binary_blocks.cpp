#include "analyzer/readers/binary_blocks.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <zlib.h>

#include "analyzer/readers/vtk_types.hpp"

namespace recoat {
namespace {

constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

constexpr std::uint32_t no_digit = 64;

/// Value of every character as a digit of base64.
constexpr auto digits = [] {
    std::array<std::uint8_t, 256> table = {};
    table.fill(no_digit);
    for (std::size_t i = 0; i < alphabet.size(); ++i) {
        table[static_cast<unsigned char>(alphabet[i])] = static_cast<std::uint8_t>(i);
    }
    return table;
}();

std::uint32_t digit(char c) { return digits[static_cast<unsigned char>(c)]; }

std::size_t take_natural(ByteStream& stream, BlockHeader header) {
    return static_cast<std::size_t>(natural_from(stream.take(header.size), header.big_endian));
}

}  // namespace

std::string ByteStream::take(std::size_t count) {
    if (count > text_.size() + group_.size()) throw BlockError("ends too early");
    std::string bytes;
    if (!base64_) {
        if (count > text_.size()) throw BlockError("ends too early");
        bytes = text_.substr(0, count);
        text_.remove_prefix(count);
        return bytes;
    }
    bytes.reserve(count);
    while (bytes.size() < count) {
        if (group_begin_ == group_end_) take_plain_groups(bytes, count);
        if (bytes.size() == count) break;
        if (group_begin_ == group_end_) decode_group();
        bytes += group_[group_begin_++];
    }
    return bytes;
}

/// As many whole groups as come without white space or padding.
void ByteStream::take_plain_groups(std::string& bytes, std::size_t count) {
    while (bytes.size() + 3 <= count && text_.size() >= 4) {
        const std::uint32_t a = digit(text_[0]), b = digit(text_[1]), c = digit(text_[2]), d = digit(text_[3]);
        if (((a | b | c | d) & no_digit) != 0) return;
        const std::uint32_t bits = (a << 18) | (b << 12) | (c << 6) | d;
        const std::array<char, 3> group = {static_cast<char>(bits >> 16), static_cast<char>(bits >> 8),
                                           static_cast<char>(bits)};
        bytes.append(group.data(), group.size());
        text_.remove_prefix(4);
    }
}

/// Four characters make three bytes, fewer with padding.
void ByteStream::decode_group() {
    std::uint32_t bits = 0;
    std::size_t characters = 0, padding = 0;
    while (characters < 4) {
        if (text_.empty()) throw BlockError("ends too early");
        const char c = text_.front();
        text_.remove_prefix(1);
        if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
        const std::uint32_t value = c == '=' ? 0 : digit(c);
        if (value == no_digit || (c != '=' && padding > 0)) throw BlockError("is not written in base64");
        padding += c == '=' ? 1 : 0;
        bits = (bits << 6) | value;
        ++characters;
    }
    if (padding > 2) throw BlockError("is not written in base64");
    group_ = {static_cast<char>(bits >> 16), static_cast<char>(bits >> 8), static_cast<char>(bits)};
    group_begin_ = 0;
    group_end_ = 3 - padding;
}

std::string read_plain(ByteStream& stream, BlockHeader header, std::size_t size) {
    const std::size_t length = take_natural(stream, header);
    if (length != size) throw BlockError(fmt::format("has {} bytes instead of {}", length, size));
    return stream.take(size);
}

std::string read_compressed(ByteStream& stream, BlockHeader header, std::size_t size) {
    const std::size_t blocks = take_natural(stream, header);
    const std::size_t block_size = take_natural(stream, header), last_size = take_natural(stream, header);
    const std::size_t last = last_size == 0 ? block_size : last_size;
    // Division instead of products: the numbers may be anything.
    const bool one_size = blocks < 2 || (last <= size && block_size > 0 && (size - last) % block_size == 0 &&
                                         (size - last) / block_size == blocks - 1);
    if (!one_size || (blocks == 1 && last != size) || (blocks == 0 && size != 0)) {
        throw BlockError(fmt::format("has {} blocks of {} bytes, the last of {}, instead of {} bytes in all", blocks,
                                     block_size, last, size));
    }
    std::vector<std::size_t> compressed;
    for (std::size_t i = 0; i < blocks; ++i) compressed.push_back(take_natural(stream, header));
    std::string bytes(size, '\0');
    std::size_t begin = 0;
    for (std::size_t i = 0; i < blocks; ++i) {
        const std::string packed = stream.take(compressed[i]);
        const std::size_t expected = i + 1 == blocks ? last : block_size;
        uLongf unpacked = expected;
        const int status = ::uncompress(reinterpret_cast<Bytef*>(bytes.data() + begin), &unpacked,
                                        reinterpret_cast<const Bytef*>(packed.data()), packed.size());
        if (status != Z_OK || unpacked != expected) throw BlockError(fmt::format("is damaged in block {}", i));
        begin += expected;
    }
    return bytes;
}

}  // namespace recoat
