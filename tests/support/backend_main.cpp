#include <cstdio>

#include <gtest/gtest.h>

#include "solver/execution/devices.hpp"
#include "tests/support/backend.hpp"

/// As gtest_main; on a machine without the device that the tests should run on, they are reported as skipped.
int main(int argc, char** argv) {
    ::testing::InitGoogleTest(&argc, argv);
    if (recoat::testing::test_resources().backend == recoat::Backend::cuda) {
        const recoat::Devices devices = recoat::cuda_devices();
        if (devices.found.empty()) {
            std::printf("[  SKIPPED ] all tests: no CUDA device, %s\n", devices.problem.c_str());
            return 77;
        }
        const int number = recoat::testing::test_device();
        recoat::require_device(devices, number);
        std::printf("[ DEVICE   ] %d, %s\n", number, devices.found[static_cast<std::size_t>(number)].name.c_str());
    }
    return RUN_ALL_TESTS();
}
