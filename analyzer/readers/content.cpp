#include "analyzer/readers/content.hpp"

#include <memory>

#include <fmt/format.h>
#include <zlib.h>

#include "common/error.hpp"

namespace recoat {
namespace {

constexpr unsigned chunk_size = 1U << 20;
constexpr std::string_view hdf5_signature = "\x89HDF\r\n\x1a\n";

struct CloseGzip {
    void operator()(gzFile file) const { gzclose(file); }
};

}  // namespace

Content load_content(const std::filesystem::path& file) {
    // zlib hands over the bytes of files that are not packed as they are.
    const std::unique_ptr<gzFile_s, CloseGzip> stream(std::filesystem::is_directory(file) ? nullptr
                                                                                          : gzopen(file.c_str(), "rb"));
    if (!stream) {
        throw InputError(fmt::format("{}: the file cannot be read; check its name and permissions", file.string()));
    }
    gzbuffer(stream.get(), chunk_size);
    Content content;
    content.file = file;
    for (int count = 1; count > 0;) {
        const std::size_t size = content.bytes.size();
        content.bytes.resize(size + chunk_size);
        count = gzread(stream.get(), content.bytes.data() + size, chunk_size);
        content.bytes.resize(size + static_cast<std::size_t>(std::max(count, 0)));
        if (content.bytes.starts_with(hdf5_signature)) return content;
    }
    content.packed = gzdirect(stream.get()) == 0;
    int status = Z_OK;
    const std::string reason = gzerror(stream.get(), &status);
    if (status != Z_OK) {
        throw InputError(content.packed ? fmt::format("{}: the compressed data are damaged or end too early ({}); copy "
                                                      "the file again from where it was made",
                                                      file.string(), reason)
                                        : fmt::format("{}: the file cannot be read ({}); check the disk it lies on",
                                                      file.string(), reason));
    }
    if (content.bytes.empty()) {
        throw InputError(fmt::format("{}: the file is empty; give a file of particles", file.string()));
    }
    return content;
}

}  // namespace recoat
