#include <gtest/gtest.h>

#include "common/error.hpp"

namespace recoat {
namespace {

int code_of(const std::function<int()>& body, std::string& output) {
    ::testing::internal::CaptureStderr();
    const int code = run_program("recoat-test", body);
    output = ::testing::internal::GetCapturedStderr();
    return code;
}

TEST(RunProgram, ReturnsTheCodeOfTheBody) {
    std::string output;
    EXPECT_EQ(code_of([] { return 0; }, output), 0);
    EXPECT_EQ(code_of([] { return 7; }, output), 7);
    EXPECT_EQ(output, "");
}

TEST(RunProgram, BadInputIsTwoAndOneLine) {
    std::string output;
    EXPECT_EQ(code_of([]() -> int { throw InputError("a.yaml:3: the key is wrong; mend it"); }, output), 2);
    EXPECT_EQ(output, "recoat-test: error: a.yaml:3: the key is wrong; mend it\n");
}

TEST(RunProgram, SimulationFaultIsThree) {
    std::string output;
    EXPECT_EQ(code_of([]() -> int { throw SimulationFault("particle 3 left"); }, output), 3);
    EXPECT_EQ(output, "recoat-test: error: particle 3 left\n");
}

TEST(RunProgram, AnythingElseIsABug) {
    std::string output;
    EXPECT_EQ(code_of([]() -> int { throw std::logic_error("index"); }, output), 1);
    EXPECT_NE(output.find("bug"), std::string::npos);
    EXPECT_EQ(code_of([]() -> int { throw 5; }, output), 1);
    EXPECT_NE(output.find("bug"), std::string::npos);
}

}  // namespace
}  // namespace recoat
