#include <vector>

#include <gtest/gtest.h>

#include "solver/execution/cuda.cuh"
#include "tests/sanitizers/expect_finding.hpp"

// Races made on purpose between threads, blocks, streams and the host of the device that tests have: a clean run of the
// engine there says something only if these are seen.

namespace {

using recoat::Cuda;
using recoat::DeviceArray;
using recoat::Resources;
using recoat::testing::expect_finding;

constexpr unsigned blocks = 64, size = 128;

Cuda device() { return Cuda(Resources{recoat::Backend::cuda, 1, 0}); }

/// Runs a kernel of many blocks on a stream of its own.
template <class... Parameters>
void run(void (*kernel)(Parameters...), Parameters... parameters) {
    HostStream stream;
    cudaLaunchConfig_t config{};
    config.gridDim = dim3(blocks);
    config.blockDim = dim3(size);
    config.stream = &stream;
    cudaLaunchKernelEx(&config, kernel, parameters...);
    stream.wait();
}

/// Every thread reads what its neighbour writes, which may be one of another block.
void race_of_blocks() {
    Cuda space = device();
    DeviceArray<double> array;
    space.fill(array, blocks * size + 1, 1.0);
    space.for_each(blocks * size, [value = array.data()](std::size_t k) { value[k] = value[k + 1]; });
    std::vector<double> seen;
    space.copy(array, seen);
}

/// The second warp reads what the first has written, and nobody waits.
void warps_do_not_wait(double* result) {
    __shared__ double written;
    if (threadIdx.x == 0) written = 1;
    if (threadIdx.x % 32 == 0) __shfl_down_sync(~0U, 0, 1);
    if (threadIdx.x == 32) result[blockIdx.x] = written;
}

/// The block that comes last reads what the others have written, and nothing orders that.
template <bool fenced>
void last_block_reads(double* value, unsigned* ticket) {
    if (threadIdx.x != 0) return;
    value[blockIdx.x] = 1;
    if (fenced) __threadfence();
    if (atomicInc(ticket, blocks - 1) != blocks - 1) return;
    if (fenced) __threadfence();
    for (unsigned b = 0; b < blocks; ++b) value[blocks] += value[b];
}

template <bool fenced>
double sum_of_blocks() {
    std::vector<double> value(blocks + 1, 0.0);
    unsigned ticket = 0;
    run(last_block_reads<fenced>, value.data(), &ticket);
    return value[blocks];
}

void host_does_not_wait() {
    HostStream stream;
    double place = 0;
    stream.add([&place](Crew&) { place = 1; });
    place += 1;
    stream.wait();
}

TEST(Planted, RaceOfBlocks) { expect_finding(race_of_blocks, "data race"); }
TEST(Planted, WarpsThatDoNotWait) {
    expect_finding(
        [] {
            std::vector<double> result(blocks);
            run(warps_do_not_wait, result.data());
        },
        "data race");
}
TEST(Planted, LastBlockWithoutAFence) { expect_finding(sum_of_blocks<false>, "data race"); }
TEST(Planted, HostThatDoesNotWait) { expect_finding(host_does_not_wait, "data race"); }

TEST(NoRace, LastBlockWithAFence) { EXPECT_EQ(sum_of_blocks<true>(), blocks); }

}  // namespace
