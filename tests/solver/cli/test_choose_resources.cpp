#include <gtest/gtest.h>

#include "common/error.hpp"
#include "solver/cli/choose_resources.hpp"
#include "tests/support/throws_message.hpp"

namespace recoat {
namespace {

const Devices none{{}, "the driver sees no device"}, one{{{"GPU", 1, 9, 0}}, ""}, old{{{"GPU", 1, 7, 5}}, ""};

TEST(ChooseResources, AutoTakesADeviceWhereOneCanBeUsed) {
    EXPECT_EQ(choose_resources({"auto", 0, 2}, one).backend, Backend::cuda);
    EXPECT_EQ(choose_resources({"auto", 0, 2}, none).backend, Backend::cpu);
    EXPECT_EQ(choose_resources({"auto", 0, 2}, old).backend, Backend::cpu);
    EXPECT_EQ(choose_resources({"auto", 1, 2}, one).backend, Backend::cpu);
}

TEST(ChooseResources, TakesWhatIsAskedForOrSaysWhyNot) {
    EXPECT_EQ(choose_resources({"cpu", 0, 2}, one).backend, Backend::cpu);
    EXPECT_EQ(choose_resources({"cuda", 0, 2}, one).backend, Backend::cuda);
    EXPECT_EQ(testing::message_of<InputError>([] {
                  choose_resources({"cuda", 0, 2}, none);
              }),
              "no CUDA device can be used: the driver sees no device; use --backend cpu");
}

TEST(ChooseResources, AllThreadsUnlessTold) {
    EXPECT_EQ(choose_resources({"cpu", 0, 3}, none).threads, 3);
    EXPECT_GE(choose_resources({"cpu", 0, 0}, none).threads, 1);
}

}  // namespace
}  // namespace recoat
