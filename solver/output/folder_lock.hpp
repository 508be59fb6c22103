#pragma once

#include <filesystem>

namespace recoat {

/// A folder in which only this process works; it ends with the process, however that ends.
class FolderLock {
public:
    /// Throws InputError when another process works in the folder. Where the file system knows no locks there is none.
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

private:
    int descriptor_ = -1;
};

/// Removes unfinished files that a killed process left in `folder`; only for the holder of its lock.
void remove_unfinished_files(const std::filesystem::path& folder);

}  // namespace recoat
