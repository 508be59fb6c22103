#pragma once

#include <cstdlib>
#include <string>

#include "solver/execution/resources.hpp"

namespace recoat::testing {

/// Where the tests compute: RECOAT_TEST_BACKEND=cuda runs the very same tests on a CUDA device.
inline Resources test_resources() {
    const char* wanted = std::getenv("RECOAT_TEST_BACKEND");
    return {wanted != nullptr && std::string(wanted) == "cuda" ? Backend::cuda : Backend::cpu, 1, 0};
}

/// Whether that is a device, where each of the few particles' steps costs launches: long series are shortened there.
inline bool on_device() { return test_resources().backend == Backend::cuda; }

}  // namespace recoat::testing
