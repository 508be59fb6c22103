#include <gtest/gtest.h>

#include "common/error.hpp"
#include "solver/execution/devices.hpp"
#include "tests/support/throws_message.hpp"

namespace recoat {
namespace {

using testing::message_of;

const Device modern{"GPU A", std::size_t{80} << 30, 9, 0, ""}, old{"GPU B", std::size_t{16} << 30, 7, 0, ""},
    dumb{"", 0, 0, 0, "the driver says \"unknown error\""};

TEST(Devices, ThereIsAReasonOrADevice) {
    const Devices here = cuda_devices();
    EXPECT_NE(here.found.empty(), here.problem.empty());
}

TEST(RequireDevice, TakesOneThatIsThere) {
    EXPECT_NO_THROW(require_device({{modern}, "", false}, 0));
    EXPECT_NO_THROW(require_device({{old, modern}, "", false}, 1));
}

TEST(RequireDevice, SaysWhyThereIsNone) {
    EXPECT_EQ(message_of<InputError>([] {
                  require_device({{}, "the driver sees no device", false}, 0);
              }),
              "no CUDA device can be used: the driver sees no device; use --backend cpu");
}

TEST(RequireDevice, NamesTheNumbersThatThereAre) {
    EXPECT_EQ(message_of<InputError>([] {
                  require_device({{modern}, "", false}, 1);
              }),
              "there is no CUDA device 1: this machine has 1, number 0");
    EXPECT_EQ(message_of<InputError>([] {
                  require_device({{modern, modern}, "", false}, 2);
              }),
              "there is no CUDA device 2: this machine has 2, numbers 0 to 1");
}

TEST(RequireDevice, RefusesAnOldOneByName) {
    EXPECT_EQ(message_of<InputError>([] {
                  require_device({{old}, "", false}, 0);
              }),
              "CUDA device 0 (GPU B) has compute capability 7.0, but 8.0 is needed; use another device, or --backend "
              "cpu");
}

// A device that tells nothing of itself keeps its number, and so do those after it.
TEST(RequireDevice, RefusesOneThatTellsNothing) {
    const Devices devices{{dumb, modern}, "", false};
    EXPECT_NO_THROW(require_device(devices, 1));
    EXPECT_EQ(message_of<InputError>([&] { require_device(devices, 0); }),
              "CUDA device 0 cannot be used: the driver says \"unknown error\"; use another device, or --backend cpu");
}

}  // namespace
}  // namespace recoat
