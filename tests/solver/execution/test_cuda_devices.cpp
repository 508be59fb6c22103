#include <gtest/gtest.h>

#include "common/error.hpp"
#include "solver/execution/cuda.cuh"
#include "solver/execution/devices.hpp"
#include "tests/support/throws_message.hpp"

// Compiled with the host as the device (tests/support/device_on_host).

namespace recoat {
namespace {

class CudaDevices : public ::testing::Test {
protected:
    void TearDown() override {
        host_device.count = 1;
        host_device.silent = -1;
        host_device.failure = cudaSuccess;
    }
};

TEST_F(CudaDevices, OneThatTellsNothingKeepsItsNumber) {
    host_device.count = 3;
    host_device.silent = 1;
    const Devices devices = cuda_devices();
    ASSERT_EQ(devices.found.size(), 3u);
    EXPECT_EQ(devices.found[0].problem, "");
    EXPECT_NE(devices.found[1].problem, "");
    EXPECT_EQ(devices.found[2].name, "the host as a device");
}

TEST_F(CudaDevices, AMachineWithoutOneSaysSo) {
    host_device.count = 0;
    const Devices devices = cuda_devices();
    EXPECT_TRUE(devices.found.empty());
    EXPECT_EQ(devices.problem, "the driver sees no device");
    EXPECT_FALSE(devices.out_of_reach);
}

TEST_F(CudaDevices, ATrialTellsWhyADeviceCannotBeUsed) {
    EXPECT_EQ(try_device(0), "");
    EXPECT_NE(try_device(1).find("CUDA device 1 cannot be used"), std::string::npos);
    host_device.failure = cudaErrorDevicesUnavailable;
    EXPECT_NE(try_device(0).find("CUDA device 0 is taken by another program"), std::string::npos);
    host_device.failure = cudaErrorECCUncorrectable;
    EXPECT_NE(try_device(0).find("CUDA device 0 has failed"), std::string::npos);
    host_device.failure = cudaErrorNoKernelImageForDevice;
    EXPECT_NE(try_device(0).find("no code for CUDA device 0"), std::string::npos);
}

TEST_F(CudaDevices, ASpaceOnADeviceThatIsTakenIsNoBug) {
    host_device.failure = cudaErrorDevicesUnavailable;
    EXPECT_NE(testing::message_of<InputError>([] {
                  Cuda space({Backend::cuda, 1, 0});
              }).find("taken"),
              std::string::npos);
}

TEST_F(CudaDevices, ADeviceThatBreaksInARunIsAFaultAndNoBug) {
    Cuda space({Backend::cuda, 1, 0});
    host_device.failure = cudaErrorECCUncorrectable;
    DeviceArray<double> array;
    EXPECT_NE(testing::message_of<SimulationFault>([&] { space.fill(array, 10, 0.0); }).find("has failed"),
              std::string::npos);
}

}  // namespace
}  // namespace recoat
