#include "analyzer/readers/content.hpp"

#include <cstdio>
#include <memory>

#include <fmt/format.h>

#include "analyzer/readers/packing.hpp"
#include "common/error.hpp"
#include "common/text_encoding.hpp"

namespace recoat {
namespace {

constexpr std::size_t first_size = 4096;
constexpr std::string_view hdf5_signature = "\x89HDF\r\n\x1a\n";

/// At the start, or behind a block of the user.
bool has_hdf5_signature(std::string_view head) {
    for (const std::size_t place : {0U, 512U, 1024U, 2048U}) {
        if (place < head.size() && head.substr(place).starts_with(hdf5_signature)) return true;
    }
    return false;
}

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

/// All bytes of a file; of an HDF5 file only the first ones.
std::string read_bytes(const std::filesystem::path& file) {
    const std::unique_ptr<std::FILE, CloseFile> stream(
        std::filesystem::is_directory(file) ? nullptr : std::fopen(file.c_str(), "rb"));
    if (!stream) {
        throw InputError(fmt::format("{}: the file cannot be read; check its name and permissions", file.string()));
    }
    std::error_code no_size;  // of a pipe
    const auto expected = std::filesystem::file_size(file, no_size);
    std::string bytes(first_size, '\0');
    std::size_t size = 0;
    for (std::size_t count = 1; count > 0;) {
        count = std::fread(bytes.data() + size, 1, bytes.size() - size, stream.get());
        size += count;
        if (has_hdf5_signature(std::string_view(bytes).substr(0, size))) break;
        // One more than the file has, to meet its end.
        if (size == bytes.size()) bytes.resize(no_size || expected < size ? 2 * size : expected + 1);
    }
    if (std::ferror(stream.get()) != 0) {
        throw InputError(fmt::format("{}: the file cannot be read; check the disk it lies on", file.string()));
    }
    bytes.resize(size);
    return bytes;
}

void refuse_wide_text(const Content& content) {
    const std::string problem = wide_text_problem(content.head());
    if (!problem.empty()) throw InputError(fmt::format("{}: {}", content.name(), problem));
}

void refuse_second_packing(const Content& content, const Packing& outer) {
    const Packing* inner = packing_of(content.bytes);
    if (inner == nullptr) return;
    throw InputError(fmt::format("{}: the file is packed twice, with {} inside of {}; unpack it once", content.name(),
                                 inner->name, outer.name));
}

}  // namespace

bool Content::is_hdf5() const { return has_hdf5_signature(head()); }

Content make_content(const std::filesystem::path& file, std::string bytes) {
    Content content{.file = file, .bytes = std::move(bytes)};
    if (const Packing* packing = packing_of(content.bytes)) {
        content.bytes = unpack(*packing, content.bytes, content.name());
        content.packed = true;
        refuse_second_packing(content, *packing);
        if (content.is_hdf5()) {
            throw InputError(fmt::format("{}: HDF5 files cannot be read while packed with {}; unpack it first",
                                         content.name(), packing->name));
        }
    }
    refuse_wide_text(content);
    content.bytes.erase(0, content.bytes.size() - without_byte_order_mark(content.bytes).size());
    if (content.bytes.empty()) {
        throw InputError(fmt::format("{}: the file is empty; give a file of particles", content.name()));
    }
    return content;
}

Content load_content(const std::filesystem::path& file) { return make_content(file, read_bytes(file)); }

}  // namespace recoat
