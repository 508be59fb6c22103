#include <fstream>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/error.hpp"
#include "solver/output/folder_lock.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/throws_message.hpp"

namespace recoat {
namespace {

TEST(FolderLock, OneAtATime) {
    const testing::TemporaryFolder folder;
    std::optional<FolderLock> first(std::in_place, folder.path());
    EXPECT_THAT(testing::message_of<InputError>([&] { FolderLock second(folder.path()); }),
                ::testing::HasSubstr("another recoat-solve works in this folder"));
    first.reset();
    EXPECT_NO_THROW(FolderLock(folder.path()));
}

TEST(FolderLock, UnfinishedFilesGoAndOthersStay) {
    const testing::TemporaryFolder folder;
    for (const char* name : {".checkpoint.h5.123.part", "fill.vtkhdf", ".hidden", "mine.part"})
        std::ofstream(folder / name) << "x";
    remove_unfinished_files(folder.path());
    EXPECT_FALSE(std::filesystem::exists(folder / ".checkpoint.h5.123.part"));
    for (const char* name : {"fill.vtkhdf", ".hidden", "mine.part"})
        EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
    EXPECT_NO_THROW(remove_unfinished_files(folder / "nowhere"));
}

}  // namespace
}  // namespace recoat
