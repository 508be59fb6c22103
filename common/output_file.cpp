#include "common/output_file.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "common/error.hpp"

namespace recoat {
namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& file, const std::string& reason) {
    throw InputError(
        fmt::format("{}: the file cannot be written ({}); check the folder, its permissions and the free space",
                    file.string(), reason));
}

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

/// Brings a file or folder to the disk.
void synchronise(const fs::path& path) {
    const int descriptor = ::open(path.c_str(), O_RDONLY);
    const bool done = descriptor >= 0 && ::fsync(descriptor) == 0;
    const int error = errno;
    if (descriptor >= 0) ::close(descriptor);
    if (!done) fail(path, std::strerror(error));
}

}  // namespace

OutputFile::OutputFile(fs::path place)
    : place_(std::move(place)),
      temporary_(folder_of(place_) / fmt::format(".{}.{}.part", place_.filename().string(), ::getpid())) {
    std::error_code error;
    fs::create_directories(folder_of(place_), error);
    if (error) fail(place_, error.message());
    if (fs::is_directory(place_)) fail(place_, "a folder has this name");
    if (!std::ofstream(temporary_)) fail(place_, std::strerror(errno));
}

OutputFile::~OutputFile() {
    std::error_code ignored;
    if (!committed_) fs::remove(temporary_, ignored);
}

void OutputFile::commit() {
    synchronise(temporary_);
    std::error_code error;
    fs::rename(temporary_, place_, error);
    if (error) fail(place_, error.message());
    committed_ = true;
    synchronise(folder_of(place_));
}

TextFile::TextFile(const fs::path& place) : place_(place), file_(place), stream_(file_.path(), std::ios::binary) {}

void TextFile::add(std::string_view text) { stream_.write(text.data(), static_cast<std::streamsize>(text.size())); }

void TextFile::finish() {
    stream_.close();
    if (!stream_) fail(place_, std::strerror(errno));
    file_.commit();
}

void write_text_file(const fs::path& place, std::string_view text) {
    TextFile file(place);
    file.add(text);
    file.finish();
}

}  // namespace recoat
