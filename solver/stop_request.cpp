#include "solver/stop_request.hpp"

#include <csignal>

namespace recoat {
namespace {

volatile std::sig_atomic_t received = 0;

void remember(int signal) { received = signal; }

}  // namespace

void listen_for_stop() {
    std::signal(SIGINT, remember);
    std::signal(SIGTERM, remember);
}

int stop_signal() { return received; }

}  // namespace recoat
