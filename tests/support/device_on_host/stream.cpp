#include "tests/support/device_on_host/stream.hpp"

#include <algorithm>

namespace {

constexpr unsigned helpers_of_a_stream = 2;
/// Waking the helpers takes longer than fewer blocks.
constexpr unsigned blocks_to_share = 8;

std::mutex streams_mutex;
std::vector<HostStream*> streams;

}  // namespace

Crew::Crew(unsigned helpers) {
    for (unsigned h = 0; h < helpers; ++h) helpers_.emplace_back([this](const std::stop_token& stop) { help(stop); });
}

Crew::~Crew() = default;

void Crew::Kernel::take_blocks() {
    const unsigned count = grid.count();
    for (unsigned k = next.fetch_add(1, std::memory_order_relaxed); k < count;
         k = next.fetch_add(1, std::memory_order_relaxed))
        run_block(number % 2 == 0 ? count - 1 - k : k, grid, block, *thread);
}

void Crew::run(dim3 grid, dim3 block, const std::function<void()>& thread) {
    Kernel kernel{grid, block, &thread, ++kernels_};
    if (helpers_.empty() || grid.count() < blocks_to_share) return kernel.take_blocks();
    {
        const std::lock_guard lock(mutex_);
        open_ = &kernel;
    }
    changed_.notify_all();
    kernel.take_blocks();
    std::unique_lock lock(mutex_);
    open_ = nullptr;
    changed_.wait(lock, [&] { return busy_ == 0; });
}

void Crew::help(const std::stop_token& stop) {
    std::uint64_t last = 0;
    std::unique_lock lock(mutex_);
    while (changed_.wait(lock, stop, [&] { return open_ != nullptr && open_->number != last; })) {
        Kernel& kernel = *open_;
        last = kernel.number;
        ++busy_;
        lock.unlock();
        kernel.take_blocks();
        lock.lock();
        --busy_;
        changed_.notify_all();
    }
}

HostStream::HostStream() : crew_(helpers_of_a_stream), leader_([this](const std::stop_token& stop) { work(stop); }) {
    const std::lock_guard lock(streams_mutex);
    streams.push_back(this);
}

HostStream::~HostStream() {
    wait();
    const std::lock_guard lock(streams_mutex);
    std::erase(streams, this);
}

void HostStream::add(Work work) {
    {
        const std::lock_guard lock(mutex_);
        queue_.push_back(std::move(work));
        idle_ = false;
    }
    changed_.notify_all();
}

void HostStream::wait() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return idle_; });
}

void HostStream::work(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (changed_.wait(lock, stop, [&] { return !queue_.empty(); })) {
        const Work work = std::move(queue_.front());
        queue_.pop_front();
        lock.unlock();
        work(crew_);
        lock.lock();
        idle_ = queue_.empty();
        if (idle_) changed_.notify_all();
    }
}

void wait_for_all_streams() {
    const std::lock_guard lock(streams_mutex);
    for (HostStream* stream : streams) stream->wait();
}
