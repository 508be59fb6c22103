#pragma once

#include <string>

namespace recoat {

/// What a failed call of CUDA means.
struct CudaFailure {
    enum class Kind {
        unusable,  ///< the device cannot be used as it is now: for the user to mend
        broken,    ///< it stopped working in the middle of a run
        bug        ///< of this program
    };
    Kind kind = Kind::bug;
    std::string what;    ///< a clause: which device, what is wrong
    std::string remedy;  ///< what to do; empty for a bug
};

/// `error` is a cudaError_t, `text` the driver's words for it, `doing` what was being done, `device` the number of the
/// device, or -1 where that is not known; `versions` as from cuda_versions.
CudaFailure cuda_failure(int error, const std::string& text, const std::string& doing, int device,
                         const std::string& versions);

/// "driver for CUDA 12.4, program made with CUDA 13.0", from the numbers that CUDA gives; a driver of 0 is none.
std::string cuda_versions(int driver, int runtime);

/// Throws what the failure means: InputError, SimulationFault, or std::runtime_error for a bug.
[[noreturn]] void throw_failure(const CudaFailure& failure);

}  // namespace recoat
