#pragma once

#include <filesystem>
#include <fstream>
#include <string_view>

namespace recoat {

/// A file that appears whole or not at all: written under a temporary name beside its place, renamed by commit().
class OutputFile {
public:
    /// Makes the folder where it is missing. Throws InputError when it cannot be written to.
    explicit OutputFile(std::filesystem::path place);
    /// Removes the temporary file unless it was committed.
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// Temporary name to write to.
    [[nodiscard]] const std::filesystem::path& path() const { return temporary_; }
    /// Brings the content to the disk and gives the file its name, replacing an older one. Throws InputError.
    void commit();

private:
    std::filesystem::path place_;
    std::filesystem::path temporary_;
    bool committed_ = false;
};

/// A text file that is written piece by piece and appears whole or not at all.
class TextFile {
public:
    /// Throws InputError when it cannot be written to.
    explicit TextFile(const std::filesystem::path& place);

    /// Adds text; a full disk shows in finish().
    void add(std::string_view text);
    /// Gives the file its name. Throws InputError when some of it could not be written.
    void finish();

private:
    std::filesystem::path place_;
    OutputFile file_;
    std::ofstream stream_;
};

/// Writes a whole text file.
void write_text_file(const std::filesystem::path& place, std::string_view text);

}  // namespace recoat
