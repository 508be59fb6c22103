#include <stdexcept>

#include <gtest/gtest.h>

#include "common/error.hpp"
#include "solver/execution/cuda_failure.hpp"
#include "tests/support/throws_message.hpp"

namespace recoat {
namespace {

using Kind = CudaFailure::Kind;
using testing::message_of;

CudaFailure failure(int error) { return cuda_failure(error, "words", "taking memory", 2, "versions"); }

TEST(CudaFailure, MemoryIsForTheUserToMend) {
    EXPECT_EQ(message_of<InputError>([] { throw_failure(failure(2)); }),
              "CUDA device 2 has too little free memory (taking memory); use fewer particles, another device, or "
              "--backend cpu");
}

// Exclusive and prohibited compute modes, and what a server of several processes refuses.
TEST(CudaFailure, ADeviceThatIsTakenIsForTheUserToMend) {
    for (const int error : {46, 210, 805, 808}) {
        const std::string sentence = message_of<InputError>([&] { throw_failure(failure(error)); });
        EXPECT_NE(sentence.find("CUDA device 2 is taken by another program"), std::string::npos) << sentence;
        EXPECT_NE(sentence.find("use another device, or --backend cpu"), std::string::npos) << sentence;
    }
}

TEST(CudaFailure, VersionsAreNamedWhereTheyMatter) {
    for (const int error : {35, 36, 209, 222, 803, 999}) {
        EXPECT_EQ(failure(error).kind, Kind::unusable) << error;
        EXPECT_NE(failure(error).what.find("versions"), std::string::npos) << error;
    }
    EXPECT_NE(failure(209).remedy.find("RECOAT_CUDA_ARCHITECTURES"), std::string::npos);
}

// Uncorrectable ECC and NVLink errors, contained ones, the time limit of a display.
TEST(CudaFailure, ADeviceThatBreaksIsAFaultOfTheRunNotABug) {
    for (const int error : {214, 220, 226, 702}) {
        const std::string sentence = message_of<SimulationFault>([&] { throw_failure(failure(error)); });
        EXPECT_NE(sentence.find("CUDA device 2 has failed"), std::string::npos) << sentence;
        EXPECT_NE(sentence.find("recoat-solve resume"), std::string::npos) << sentence;
    }
}

TEST(CudaFailure, OthersAreBugs) {
    for (const int error : {1, 700, 719, 901}) {
        EXPECT_EQ(failure(error).kind, Kind::bug) << error;
        EXPECT_EQ(message_of<std::runtime_error>([&] { throw_failure(failure(error)); }),
                  "CUDA device 2, taking memory: \"words\" (versions)");
    }
}

TEST(CudaFailure, ADeviceOfUnknownNumberHasNone) {
    EXPECT_EQ(cuda_failure(2, "words", "copying", -1, "").what, "the CUDA device has too little free memory (copying)");
}

TEST(CudaVersions, AreThoseOfDriverAndProgram) {
    EXPECT_EQ(cuda_versions(12040, 13000), "driver for CUDA 12.4, program made with CUDA 13.0");
    EXPECT_EQ(cuda_versions(0, 13010), "no driver, program made with CUDA 13.1");
}

}  // namespace
}  // namespace recoat
