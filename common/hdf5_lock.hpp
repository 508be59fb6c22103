#pragma once

#include <mutex>

namespace recoat::hdf5 {

/// Held around every call to the HDF5 C library, which has global state and, unless it was built with its option for
/// threads (that of Debian was), no lock of its own. Not held between calls: a file stays open for as long as its owner
/// likes, and may be closed by another thread than the one that opened it.
class LibraryLock {
public:
    LibraryLock();

private:
    std::unique_lock<std::recursive_mutex> lock_;
};

}  // namespace recoat::hdf5
