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

TEST(EndingOf, HasTheCodeAndTheSentence) {
    const auto expect = [](const std::function<int()>& body, int code, const std::string& sentence) {
        const Ending ending = ending_of(body);
        EXPECT_EQ(ending.code, code);
        EXPECT_EQ(ending.sentence, sentence);
    };
    expect([] { return 130; }, 130, "");
    expect([]() -> int { throw InputError("mend it"); }, 2, "mend it");
    expect([]() -> int { throw SimulationFault("it left"); }, 3, "it left");
    expect([]() -> int { throw std::logic_error("index"); }, 1, "index");
    expect([]() -> int { throw 5; }, 1, "unknown exception");
}

}  // namespace
}  // namespace recoat
