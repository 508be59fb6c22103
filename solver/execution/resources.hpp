#pragma once

namespace recoat {

/// What an engine may use of the machine.
struct Resources {
    int threads = 1;  ///< of the host
    int device = 0;   ///< number of the CUDA device
};

}  // namespace recoat
