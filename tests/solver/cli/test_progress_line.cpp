#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solver/progress_line.hpp"

namespace recoat {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const Progress half{"spread", 500, 1000, 2500};

TEST(ProgressLine, TellsTheTimeLeftOfTheWholeRun) {
    // 500 steps of this stage and 2500 of later ones at 10 per second
    EXPECT_EQ(progress_text(half, 10, 1e4, 200),
              "spread [##########..........]  50 %, 1e+05 particle-steps/s, run: at most 5 min left");
}

TEST(ProgressLine, FitsAnyTerminal) {
    for (int columns = 0; columns < 120; ++columns)
        EXPECT_LE(static_cast<int>(progress_text(half, 10, 1e4, columns).size()), columns);
    EXPECT_THAT(progress_text(half, 10, 1e4, 59), AllOf(StartsWith("spread ["), HasSubstr("at most 5 min left")));
    EXPECT_EQ(progress_text(half, 10, 1e4, 19), "spread  50 %");
    EXPECT_EQ(progress_text(half, 10, 1e4, 22), "spread  50 % < 5 min");
    EXPECT_EQ(progress_text(half, 10, 1e4, 6), " 50 %");
}

TEST(ProgressLine, DoesNotGuessBeforeTheFirstStep) {
    EXPECT_THAT(progress_text(half, 0, 1e4, 200), HasSubstr("time left unknown"));
    EXPECT_THAT(progress_text({"fill", 0, 0, 0}, 0, 1, 200), HasSubstr("100 %"));
}

}  // namespace
}  // namespace recoat
