#include <atomic>
#include <thread>
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

/// Makes sure that two threads of the host run blocks of a kernel, without telling either what the other has written.
class TwoAtLeast {
public:
    void join() {
        if (threadIdx.x != 0 || begun_.fetch_add(1, std::memory_order_relaxed) > 0) return;
        while (begun_.load(std::memory_order_relaxed) < 2) std::this_thread::yield();
    }

private:
    std::atomic<int> begun_{0};
};

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
    TwoAtLeast two;
    space.for_each(blocks * size, [value = array.data(), &two](std::size_t k) {
        two.join();
        value[k] = value[k + 1];
    });
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
void last_block_reads(double* value, unsigned* ticket, TwoAtLeast* two) {
    if (threadIdx.x != 0) return;
    two->join();
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
    TwoAtLeast two;
    run(last_block_reads<fenced>, value.data(), &ticket, &two);
    return value[blocks];
}

void host_does_not_wait() {
    HostStream stream;
    double place = 0;
    std::atomic<bool> done{false};
    stream.add([&](Crew&) {
        place = 1;
        done.store(true, std::memory_order_relaxed);
    });
    while (!done.load(std::memory_order_relaxed)) std::this_thread::yield();
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
