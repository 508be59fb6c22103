#include <gtest/gtest.h>

#include "common/error.hpp"
#include "solver/cli/choose_resources.hpp"
#include "tests/support/throws_message.hpp"

namespace recoat {
namespace {

const Devices none{{}, "the driver sees no device", false}, one{{{"GPU", 1, 9, 0, ""}}, "", false},
    old{{{"GPU", 1, 7, 5, ""}}, "", false}, unfit{{}, "the driver is older than this program needs", true};

std::string works(int) { return {}; }
std::string is_taken(int number) { return "CUDA device " + std::to_string(number) + " is taken"; }

TEST(ChooseResources, AutoTakesADeviceWhereOneCanBeUsed) {
    const ResourceChoice choice = choose_resources({"auto", 0, 2}, one, works);
    EXPECT_EQ(choice.resources.backend, Backend::cuda);
    EXPECT_EQ(choice.notice, "");
}

TEST(ChooseResources, AutoIsSilentWhereThereIsNoDevice) {
    const ResourceChoice choice = choose_resources({"auto", 0, 2}, none, works);
    EXPECT_EQ(choice.resources.backend, Backend::cpu);
    EXPECT_EQ(choice.notice, "");
}

TEST(ChooseResources, AutoSaysWhyItDoesNotTakeADeviceThatIsThere) {
    const auto notice = [](int device, const Devices& devices, const DeviceTrial& trial) {
        const ResourceChoice choice = choose_resources({"auto", device, 2}, devices, trial);
        EXPECT_EQ(choice.resources.backend, Backend::cpu);
        return choice.notice;
    };
    EXPECT_EQ(notice(0, one, is_taken),
              "CUDA device 0 is taken; use another device, or --backend cpu (computing on the processor now)");
    EXPECT_NE(notice(0, old, works).find("compute capability 7.5"), std::string::npos);
    EXPECT_NE(notice(1, one, works).find("there is no CUDA device 1"), std::string::npos);
    EXPECT_NE(notice(0, unfit, works).find("older than this program needs"), std::string::npos);
}

TEST(ChooseResources, TakesWhatIsAskedForOrSaysWhyNot) {
    EXPECT_EQ(choose_resources({"cpu", 0, 2}, one, is_taken).resources.backend, Backend::cpu);
    EXPECT_EQ(choose_resources({"cuda", 0, 2}, one, works).resources.backend, Backend::cuda);
    EXPECT_EQ(testing::message_of<InputError>([] {
                  choose_resources({"cuda", 0, 2}, none, works);
              }),
              "no CUDA device can be used: the driver sees no device; use --backend cpu");
    EXPECT_EQ(testing::message_of<InputError>([] {
                  choose_resources({"cuda", 0, 2}, one, is_taken);
              }),
              "CUDA device 0 is taken; use another device, or --backend cpu");
}

TEST(ChooseResources, AllThreadsUnlessTold) {
    EXPECT_EQ(choose_resources({"cpu", 0, 3}, none, works).resources.threads, 3);
    EXPECT_GE(choose_resources({"cpu", 0, 0}, none, works).resources.threads, 1);
}

}  // namespace
}  // namespace recoat
