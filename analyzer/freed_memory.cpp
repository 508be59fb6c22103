#include "analyzer/freed_memory.hpp"

#include <malloc.h>

namespace recoat {

void keep_freed_memory() noexcept {
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, -1);
    mallopt(M_TOP_PAD, 1 << 24);
}

}  // namespace recoat
