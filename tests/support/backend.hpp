#pragma once

#include <cstdlib>
#include <string>

#include "solver/execution/resources.hpp"

namespace recoat::testing {

/// The CUDA device that tests use: RECOAT_TEST_DEVICE, or else number 0.
inline int test_device() {
    const char* wanted = std::getenv("RECOAT_TEST_DEVICE");
    return wanted != nullptr ? std::stoi(wanted) : 0;
}

/// Where the tests compute: RECOAT_TEST_BACKEND=cuda runs the very same tests on a CUDA device.
inline Resources test_resources() {
    const char* wanted = std::getenv("RECOAT_TEST_BACKEND");
    return {wanted != nullptr && std::string(wanted) == "cuda" ? Backend::cuda : Backend::cpu, 1, test_device()};
}

/// Whether that is a device, where each of the few particles' steps costs launches: long series are shortened there.
inline bool on_device() { return test_resources().backend == Backend::cuda; }

}  // namespace recoat::testing
