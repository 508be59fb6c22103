#include "solver/cli/brief_waiting.hpp"

#include <cstdlib>

#include <unistd.h>

namespace recoat {

void wait_briefly(char** arguments) {
    constexpr const char* attempts = "1000";
    if (std::getenv("OMP_WAIT_POLICY") != nullptr || std::getenv("GOMP_SPINCOUNT") != nullptr) return;
    if (setenv("GOMP_SPINCOUNT", attempts, 0) != 0) return;
    execv("/proc/self/exe", arguments);  // comes back where the system refuses it: then threads wait as they always do
}

}  // namespace recoat
