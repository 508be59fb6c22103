#include "tests/support/device_on_host/block.hpp"

#include <memory>
#include <stdexcept>
#include <vector>

#include <ucontext.h>

thread_local dim3 threadIdx, blockIdx, blockDim, gridDim;

namespace {

constexpr std::size_t stack_bytes = std::size_t{1} << 16;
constexpr unsigned warp_size = 32;

/// A thread of the block that runs now, with a stack of its own, so that it can wait at a barrier.
struct Thread {
    ucontext_t place{};
    std::unique_ptr<char[]> stack{new char[stack_bytes]};
    bool done = false;
};

struct Block {
    std::vector<Thread> threads;
    ucontext_t scheduler{};
    const std::function<void()>* body = nullptr;
    std::vector<double> exchanged;
    bool in_thread = false;
    unsigned current = 0, barriers = 0;

    static void begin();
    void resume(unsigned t) {
        current = t;
        threadIdx.x = t;
        in_thread = true;
        swapcontext(&scheduler, &threads[t].place);
        in_thread = false;
    }
    void start(unsigned t) {
        Thread& thread = threads[t];
        thread.done = false;
        getcontext(&thread.place);
        thread.place.uc_stack.ss_sp = thread.stack.get();
        thread.place.uc_stack.ss_size = stack_bytes;
        thread.place.uc_link = &scheduler;
        makecontext(&thread.place, &Block::begin, 0);
        resume(t);
    }
    void wait() {
        if (!in_thread) throw std::logic_error("some threads of a block wait at a barrier, its first one did not");
        ++barriers;
        swapcontext(&threads[current].place, &scheduler);
    }

    void run(unsigned size) {
        if (threads.size() < size) threads.resize(size);
        exchanged.assign(size, 0);
        barriers = 0;
        start(0);
        if (barriers == 0) {
            // Without barriers the order does not matter, and no stacks are needed.
            for (unsigned t = 1; t < size; ++t) {
                threadIdx.x = t;
                (*body)();
            }
            return;
        }
        for (unsigned t = 1; t < size; ++t) start(t);
        for (bool waiting = true; waiting;) {
            waiting = false;
            for (unsigned t = 0; t < size; ++t) {
                if (threads[t].done) continue;
                resume(t);
                waiting = waiting || !threads[t].done;
            }
        }
    }
};

thread_local Block block;

void Block::begin() {
    (*block.body)();
    block.threads[block.current].done = true;
}

}  // namespace

void run_kernel(dim3 grid, dim3 size, const std::function<void()>& thread) {
    gridDim = grid;
    blockDim = size;
    block.body = &thread;
    for (unsigned b = 0; b < grid.x; ++b) {
        blockIdx.x = b;
        block.run(size.x);
    }
}

void __syncthreads() { block.wait(); }

double __shfl_down_sync(unsigned, double value, unsigned distance) {
    const unsigned t = threadIdx.x, lane = t % warp_size;
    block.exchanged[t] = value;
    block.wait();
    const double other = lane + distance < warp_size ? block.exchanged[t + distance] : value;
    block.wait();
    return other;
}
