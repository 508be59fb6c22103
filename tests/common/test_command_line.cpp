#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/command_line.hpp"
#include "common/error.hpp"
#include "tests/support/throws_message.hpp"

namespace recoat {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// The sentence with which a program of two commands refuses these arguments; empty when it takes them.
std::string refusal(std::vector<const char*> arguments) {
    CLI::App app("An oven.", "oven");
    app.require_subcommand(1);
    CLI::App& bake = *app.add_subcommand("bake", "Bakes");
    std::string cake;
    int threads = 0;
    bake.add_option("cake", cake)->required();
    bake.add_option("--threads", threads)->check(whole_number(1, 8));
    app.add_subcommand("clean", "Cleans");
    arguments.insert(arguments.begin(), "oven");
    try {
        EXPECT_FALSE(parse_command_line(app, static_cast<int>(arguments.size()), arguments.data()));
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

TEST(CommandLine, TakesWhatIsRight) {
    EXPECT_EQ(refusal({"bake", "pie", "--threads", "8"}), "");
    EXPECT_EQ(refusal({"clean"}), "");
}

TEST(CommandLine, AMisspeltCommandIsToldWhatIsMeant) {
    EXPECT_THAT(refusal({"baek", "pie"}),
                AllOf(HasSubstr("no subcommand \"baek\""), HasSubstr("did you mean \"bake\"?")));
    EXPECT_THAT(refusal({"fry", "pie"}), AllOf(HasSubstr("bake, clean"), Not(HasSubstr("did you mean"))));
    EXPECT_THAT(refusal({}), HasSubstr("give one of bake, clean"));
}

TEST(CommandLine, AMisspeltOptionIsToldWhatIsMeant) {
    EXPECT_THAT(refusal({"bake", "pie", "--thread", "2"}),
                AllOf(HasSubstr("oven bake has no option --thread"), HasSubstr("did you mean \"--threads\"?")));
    EXPECT_THAT(refusal({"bake", "--thraeds=2"}), HasSubstr("did you mean \"--threads\"?"));
    EXPECT_THAT(refusal({"bake", "pie", "--colour"}), HasSubstr("oven bake --help lists them"));
    EXPECT_THAT(refusal({"--colour"}), HasSubstr("oven has no option --colour"));
}

TEST(CommandLine, OneArgumentTooManyIsNamed) { EXPECT_THAT(refusal({"bake", "pie", "tart"}), HasSubstr("\"tart\"")); }

TEST(CommandLine, NumbersOutOfTheirRangeAreToldTheRange) {
    for (const char* wrong : {"0", "9", "-1", "two", "1.5", "99999999999999999999"}) {
        EXPECT_THAT(refusal({"bake", "pie", "--threads", wrong}),
                    AllOf(HasSubstr("--threads"), HasSubstr(wrong), HasSubstr("whole number from 1 to 8")));
    }
}

}  // namespace
}  // namespace recoat
