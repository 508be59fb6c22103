#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "tests/support/device_on_host/block.hpp"

/// Threads of the host that run the blocks of one kernel at the same time.
class Crew {
public:
    /// `helpers`: threads beside the one that calls.
    explicit Crew(unsigned helpers);
    ~Crew();
    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;

    /// Runs a kernel. Blocks are taken in ascending and in descending order in turn.
    void run(dim3 grid, dim3 block, const std::function<void()>& thread);

private:
    struct Kernel {
        dim3 grid, block;
        const std::function<void()>* thread;
        std::uint64_t number;
        std::atomic<unsigned> next{0};

        void take_blocks();
    };
    void help(const std::stop_token& stop);

    std::mutex mutex_;
    std::condition_variable_any changed_;
    Kernel* open_ = nullptr;
    unsigned busy_ = 0;
    std::uint64_t kernels_ = 0;  ///< so far
    std::vector<std::jthread> helpers_;
};

/// Work of a stream: a kernel takes the crew.
using Work = std::function<void(Crew&)>;
using Recording = std::vector<Work>;

/// Does its work in order, on threads of its own: the host goes on meanwhile, as with a stream of a device.
class HostStream {
public:
    HostStream();
    ~HostStream();
    HostStream(const HostStream&) = delete;
    HostStream& operator=(const HostStream&) = delete;

    void add(Work work);
    void wait();

    bool recording = false;
    Recording recorded;

private:
    void work(const std::stop_token& stop);

    Crew crew_;
    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::deque<Work> queue_;
    bool idle_ = true;
    std::jthread leader_;
};

/// Waits for every stream that there is.
void wait_for_all_streams();
