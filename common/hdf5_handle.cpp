#include <utility>

#include "common/hdf5.hpp"
#include "common/hdf5_lock.hpp"

namespace recoat::hdf5 {
namespace {

/// Recursive, for members call each other and temporaries close themselves.
std::recursive_mutex& library_mutex() {
    static std::recursive_mutex mutex;
    return mutex;
}

}  // namespace

LibraryLock::LibraryLock() : lock_(library_mutex()) {}

Handle::Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}

Handle& Handle::operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
}

Handle::~Handle() { close(); }

int Handle::close() {
    const std::int64_t id = std::exchange(id_, -1);
    if (id < 0) return 0;
    const LibraryLock lock;
    return close_(id);
}

}  // namespace recoat::hdf5
