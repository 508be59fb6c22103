#include <vector>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "analyzer/freed_memory.hpp"

namespace recoat {
namespace {

constexpr std::size_t large = 64 << 20, page = 4096;

/// Pages that the system hands out while an array is made.
long pages_for_an_array() {
    rusage before{}, after{};
    getrusage(RUSAGE_SELF, &before);
    const std::vector<char> array(large, 1);
    EXPECT_EQ(array.back(), 1);
    getrusage(RUSAGE_SELF, &after);
    return after.ru_minflt - before.ru_minflt;
}

TEST(FreedMemory, IsUsedAgainWithoutNewPages) {
    keep_freed_memory();
    static_cast<void>(pages_for_an_array());
    EXPECT_LT(pages_for_an_array(), static_cast<long>(large / page / 50));
}

}  // namespace
}  // namespace recoat
