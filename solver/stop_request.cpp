#include "solver/stop_request.hpp"

#include <atomic>
#include <csignal>

namespace recoat {
namespace {

/// Written by whichever thread the signal meets, read by those that run.
std::atomic<int> received = 0;
static_assert(std::atomic<int>::is_always_lock_free, "or a signal handler may not write it");

void remember(int signal) { received = signal; }

}  // namespace

void listen_for_stop() {
    std::signal(SIGINT, remember);
    std::signal(SIGTERM, remember);
}

int stop_signal() { return received; }

}  // namespace recoat
