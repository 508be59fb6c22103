#include "tests/support/device_on_host/block.hpp"

#include <deque>
#include <stdexcept>

#include "tests/support/device_on_host/fiber.hpp"

thread_local dim3 threadIdx, blockIdx, blockDim, gridDim;

namespace {

constexpr unsigned warp_size = 32;

struct Thread {
    Fiber fiber;
    bool begun = false, done = false;
    unsigned shuffles = 0;
    double exchanged[2] = {};
};

/// Threads that wait for each other: a block, or a warp.
struct Group {
    Meeting meeting;
    unsigned alive = 0, arrived = 0, round = 0;

    void begin(unsigned threads) {
        alive = threads;
        arrived = 0;
    }
    void open_if_all_arrived() {
        if (arrived < alive) return;
        arrived = 0;
        ++round;
    }
    void leave_for_good() {
        --alive;
        if (alive > 0) open_if_all_arrived();
    }
};

/// The block that a thread of the host runs now.
class Block {
public:
    void run(unsigned size, const std::function<void()>& body) {
        while (threads_.size() < size) threads_.emplace_back();
        while (warps_.size() * warp_size < size) warps_.emplace_back();
        for (unsigned w = 0; w * warp_size < size; ++w)
            warps_[w].begin(size - w * warp_size < warp_size ? size - w * warp_size : warp_size);
        all_.begin(size);
        size_ = size;
        body_ = &body;
        started_ = 0;
        waited_ = false;
        host_.adopt_caller();
        edge_.arrive(0);
        in_fiber_ = true;
        start_next(host_);
        in_fiber_ = false;
        edge_.leave(1);
    }

    void synchronize() { meet(all_); }

    double shuffle_down(double value, unsigned distance) {
        const unsigned self = threadIdx.x, lane = self % warp_size;
        const unsigned round = threads_[self].shuffles++ % 2;
        threads_[self].exchanged[round] = value;
        meet(warps_[self / warp_size]);
        return lane + distance < warp_size ? threads_[self + distance].exchanged[round] : value;
    }

private:
    /// Where a fiber lives, block after block.
    [[noreturn]] static void live();
    void run_thread();

    void meet(Group& group) {
        if (!in_fiber_) throw std::logic_error("a thread of a block waits, but its first one did not");
        waited_ = true;
        const unsigned round = group.round, self = threadIdx.x;
        group.meeting.arrive(round);
        ++group.arrived;
        group.open_if_all_arrived();
        while (group.round == round) {
            go_on(threads_[self].fiber);
            threadIdx.x = self;
        }
        group.meeting.leave(round);
    }

    void start_next(Fiber& from) {
        const unsigned t = started_++;
        Thread& thread = threads_[t];
        thread.done = false;
        thread.shuffles = 0;
        if (!thread.begun) thread.fiber.begin_at(&Block::live);
        thread.begun = true;
        threadIdx.x = t;
        from.switch_to(thread.fiber);
    }

    /// The next thread that has something to do, or else the host.
    void go_on(Fiber& from) {
        if (started_ < size_) return start_next(from);
        for (unsigned k = 1; k <= size_; ++k) {
            const unsigned t = (threadIdx.x + k) % size_;
            if (threads_[t].done) continue;
            if (&threads_[t].fiber == &from) return;
            threadIdx.x = t;
            return from.switch_to(threads_[t].fiber);
        }
        from.switch_to(host_);
    }

    std::deque<Thread> threads_;
    std::deque<Group> warps_;
    Group all_;
    Meeting edge_;  ///< of the block and the host
    Fiber host_;
    const std::function<void()>* body_ = nullptr;
    unsigned size_ = 0, started_ = 0;
    bool in_fiber_ = false, waited_ = false;
};

thread_local Block block;

void Block::live() {
    for (;;) block.run_thread();
}

void Block::run_thread() {
    edge_.leave(0);
    (*body_)();
    const unsigned self = threadIdx.x;
    Thread& thread = threads_[self];
    if (self == 0 && !waited_) {
        // Without barriers the order does not matter, and no further stacks are needed.
        in_fiber_ = false;
        for (unsigned t = 1; t < size_; ++t) {
            threadIdx.x = t;
            (*body_)();
        }
        started_ = size_;
        for (Thread& other : threads_) other.done = true;
        threadIdx.x = self;
    }
    thread.done = true;
    warps_[threadIdx.x / warp_size].leave_for_good();
    all_.leave_for_good();
    edge_.arrive(1);
    go_on(thread.fiber);
}

}  // namespace

void run_block(unsigned number, dim3 grid, dim3 size, const std::function<void()>& thread) {
    gridDim = grid;
    blockDim = size;
    blockIdx = dim3(number % grid.x, number / grid.x % grid.y, number / grid.x / grid.y);
    threadIdx = dim3(0, 0, 0);
    block.run(size.x, thread);
}

void __syncthreads() { block.synchronize(); }
double __shfl_down_sync(unsigned, double value, unsigned distance) { return block.shuffle_down(value, distance); }
