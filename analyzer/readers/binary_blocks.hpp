#pragma once

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace recoat {

/// The bytes of an array are not as they should be; the message goes on after the name of the array.
struct BlockError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Gives bytes one after the other, as they are or out of base64, in which padding may stand between two parts.
class ByteStream {
public:
    ByteStream(std::string_view text, bool base64) : text_(text), base64_(base64) {}

    /// The next bytes. Throws BlockError when there are not as many.
    [[nodiscard]] std::string take(std::size_t count);

private:
    void take_plain_groups(std::string& bytes, std::size_t count);
    void decode_group();

    std::string_view text_;
    bool base64_;
    std::array<char, 3> group_ = {};  ///< decoded and not yet taken
    std::size_t group_begin_ = 0, group_end_ = 0;
};

/// How the numbers in front of the data are written.
struct BlockHeader {
    std::size_t size = 4;  ///< bytes of each
    bool big_endian = false;
};

/// Data behind their length. Throws BlockError when that is not `size` or the data end early.
[[nodiscard]] std::string read_plain(ByteStream& stream, BlockHeader header, std::size_t size);

/// Data in blocks compressed with zlib: number of blocks, size of a block, of the last one, compressed size of each.
[[nodiscard]] std::string read_compressed(ByteStream& stream, BlockHeader header, std::size_t size);

}  // namespace recoat
