#include <gtest/gtest.h>

#include "solver/cli/share_cores.hpp"

namespace recoat {
namespace {

void expect_share(const ShareRequest& request, int cases, int cores, Backend backend, int jobs, int threads) {
    const Share share = share_cores(request, cases, cores, backend);
    EXPECT_EQ(share.jobs, jobs) << cases << " cases, " << cores << " cores";
    EXPECT_EQ(share.threads, threads) << cases << " cases, " << cores << " cores";
}

TEST(ShareCores, TheCpuHasACaseForEveryCore) {
    expect_share({}, 6, 4, Backend::cpu, 4, 1);
    expect_share({}, 2, 16, Backend::cpu, 2, 8);
    expect_share({}, 3, 16, Backend::cpu, 3, 5);
    expect_share({}, 1, 4, Backend::cpu, 1, 4);
    expect_share({}, 5, 1, Backend::cpu, 1, 1);
}

TEST(ShareCores, ThreadsAskedForLimitTheJobs) {
    expect_share({.threads = 4}, 6, 16, Backend::cpu, 4, 4);
    expect_share({.threads = 3}, 6, 16, Backend::cpu, 5, 3);
    expect_share({.threads = 8}, 6, 4, Backend::cpu, 1, 8);
}

TEST(ShareCores, JobsAskedForShareTheCores) {
    expect_share({.jobs = 2}, 6, 16, Backend::cpu, 2, 8);
    expect_share({.jobs = 8}, 6, 4, Backend::cpu, 6, 1);
    expect_share({.jobs = 3, .threads = 2}, 6, 4, Backend::cpu, 3, 2);
}

TEST(ShareCores, ADeviceTakesAllCases) {
    expect_share({}, 12, 4, Backend::cuda, 12, 1);
    expect_share({}, 2, 16, Backend::cuda, 2, 8);
    expect_share({.threads = 2}, 12, 4, Backend::cuda, 12, 2);
    expect_share({.jobs = 5}, 12, 4, Backend::cuda, 5, 1);
}

}  // namespace
}  // namespace recoat
