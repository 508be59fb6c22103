#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "common/error.hpp"
#include "common/output_file.hpp"
#include "tests/support/temporary_folder.hpp"

namespace recoat {
namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::size_t files_in(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator{}));
}

TEST(OutputFile, AppearsOnlyWhenCommitted) {
    const testing::TemporaryFolder folder;
    const fs::path place = folder / "a.txt";
    OutputFile file(place);
    std::ofstream(file.path()) << "whole";
    EXPECT_FALSE(fs::exists(place));
    EXPECT_EQ(file.path().parent_path(), place.parent_path());
    file.commit();
    EXPECT_EQ(content(place), "whole");
    EXPECT_EQ(files_in(folder.path()), 1U);
}

TEST(OutputFile, LeavesNothingWithoutCommit) {
    const testing::TemporaryFolder folder;
    write_text_file(folder / "a.txt", "older");
    {
        OutputFile file(folder / "a.txt");
        std::ofstream(file.path()) << "half";
    }
    EXPECT_EQ(content(folder / "a.txt"), "older");
    EXPECT_EQ(files_in(folder.path()), 1U);
}

TEST(OutputFile, ReplacesAnOlderFileAndMakesFolders) {
    const testing::TemporaryFolder folder;
    write_text_file(folder.path() / "b" / "c" / "a.txt", "older");
    write_text_file(folder.path() / "b" / "c" / "a.txt", "newer");
    EXPECT_EQ(content(folder.path() / "b" / "c" / "a.txt"), "newer");
}

TEST(OutputFile, RefusesPlacesThatCannotBeWritten) {
    const testing::TemporaryFolder folder;
    write_text_file(folder / "file", "x");
    EXPECT_THROW(OutputFile(folder / "file/below"), InputError);
    EXPECT_THROW(OutputFile{folder.path()}, InputError);
}

}  // namespace
}  // namespace recoat
