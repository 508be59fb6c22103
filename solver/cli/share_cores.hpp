#pragma once

#include "solver/execution/resources.hpp"

namespace recoat {

/// What the user asked for on the command line of a sweep.
struct ShareRequest {
    int jobs = 0;     ///< cases at the same time; 0: as many as fit
    int threads = 0;  ///< of each case; 0: the cores that they leave each other
};

/// How the cases of a sweep share a machine.
struct Share {
    int jobs = 1;     ///< cases at the same time
    int threads = 1;  ///< of each case
};

/// What was asked for is taken. Else, on a CUDA device all cases run at the same time; on the CPU as many as there are
/// cores for, each with as many threads as are left for it.
Share share_cores(const ShareRequest& request, int cases, int cores, Backend backend);

}  // namespace recoat
