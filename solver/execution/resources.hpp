#pragma once

#include <string>

#include "solver/execution/instruction_set.hpp"

namespace recoat {

/// Where loops run.
enum class Backend { cpu, cuda };

/// What an engine may use of the machine.
struct Resources {
    Backend backend = Backend::cpu;
    int threads = 1;                                         ///< of the host
    int device = 0;                                          ///< number of the CUDA device
    InstructionSet instructions = chosen_instruction_set();  ///< of the host's loops
};

/// As it stands in results.
inline std::string name_of(Backend backend) { return backend == Backend::cuda ? "cuda" : "openmp"; }

}  // namespace recoat
