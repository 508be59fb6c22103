#include "analyzer/readers/gzip.hpp"

#include <algorithm>
#include <new>

#include <fmt/format.h>
// Input is not written to.
#define ZLIB_CONST
#include <zlib.h>

#include "common/error.hpp"

namespace recoat {
namespace {

constexpr std::string_view magic = "\x1f\x8b";
constexpr std::size_t usual_ratio = 4;
constexpr std::size_t largest_piece = std::size_t{1} << 30;  // zlib counts in 32 bits
constexpr int window_of_gzip = 15 + 16;

/// Unpacks bytes piece by piece.
class Inflater {
public:
    Inflater(std::string_view packed, const std::string& file) : rest_(packed), file_(file) {
        if (inflateInit2(&stream_, window_of_gzip) != Z_OK) throw std::bad_alloc();
    }
    ~Inflater() { inflateEnd(&stream_); }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;

    std::string all() {
        std::string bytes(usual_ratio * rest_.size(), '\0');
        std::size_t size = 0;
        while (true) {
            if (size == bytes.size()) bytes.resize(2 * size);
            const std::size_t room = std::min(bytes.size() - size, largest_piece);
            const int status = step(bytes.data() + size, room);
            size += room - stream_.avail_out;
            if (status != Z_STREAM_END) continue;
            if (!next_member()) break;
        }
        bytes.resize(size);
        return bytes;
    }

private:
    int step(char* place, std::size_t room) {
        const std::size_t piece = std::min(rest_.size(), largest_piece);
        stream_.next_in = reinterpret_cast<const Bytef*>(rest_.data());
        stream_.avail_in = static_cast<uInt>(piece);
        stream_.next_out = reinterpret_cast<Bytef*>(place);
        stream_.avail_out = static_cast<uInt>(room);
        const int status = inflate(&stream_, Z_NO_FLUSH);
        rest_.remove_prefix(piece - stream_.avail_in);
        if (status != Z_OK && status != Z_STREAM_END && status != Z_BUF_ERROR) {
            fail(stream_.msg != nullptr ? stream_.msg : "no valid block");
        }
        // Room was left, so it was the bytes that gave out.
        if (status != Z_STREAM_END && rest_.empty() && stream_.avail_out > 0) fail("end of the file");
        return status;
    }

    bool next_member() {
        if (rest_.find_first_not_of('\0') == std::string_view::npos) return false;
        if (!is_gzip(rest_)) fail("something else follows them");
        inflateReset(&stream_);
        return true;
    }

    [[noreturn]] void fail(const char* reason) const {
        throw InputError(
            fmt::format("{}: the compressed data are damaged or end too early ({}); copy the file again from where it "
                        "was made",
                        file_, reason));
    }

    std::string_view rest_;
    const std::string& file_;
    z_stream stream_ = {};
};

}  // namespace

bool is_gzip(std::string_view bytes) { return bytes.starts_with(magic); }

std::string unpack_gzip(std::string_view packed, const std::string& file) { return Inflater(packed, file).all(); }

}  // namespace recoat
