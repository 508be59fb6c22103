#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solver/run_ending.hpp"
#include "solver/run_files.hpp"
#include "tests/support/scene_text.hpp"

namespace recoat {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class RunEnding : public ::testing::Test {
protected:
    RunEnding() {
        for (const Stage& stage : scene_.stages) {
            progress_.finished.emplace_back();
            progress_.finished.back().name = stage.name;
            progress_.finished.back().settled = true;
        }
    }
    Scene scene_ = testing::scene_of(testing::spread_text);
    RunProgress progress_;
};

TEST_F(RunEnding, SaysWhatWasMadeWhereAndWhatIsNext) {
    progress_.frames = {1, 2, 3};
    const std::string text = run_ending(scene_, progress_, "results/a b");
    EXPECT_THAT(text, AllOf(HasSubstr("In results/a b: fill.vtkhdf, heap.vtkhdf and spread.vtkhdf"),
                            HasSubstr("trajectory.vtkhdf (3 states)"), HasSubstr("summary.json"),
                            HasSubstr("\nNext: recoat-analyze metrics \"results/a b/spread.vtkhdf\"")));
    EXPECT_THAT(text, AllOf(Not(HasSubstr("Not at rest")), Not(HasSubstr("energy.csv"))));
}

TEST_F(RunEnding, NamesStagesThatDidNotComeToRest) {
    progress_.finished[1].settled = false;
    EXPECT_THAT(run_ending(scene_, progress_, "out"), HasSubstr("Not at rest when the settle_time was over: heap;"));
}

TEST_F(RunEnding, OfAStageSaysWhetherItSettled) {
    StageRecord record = progress_.finished[0];
    record.steps = 14200;
    record.time = 1.42e-3;
    EXPECT_EQ(stage_ending(scene_.stages[0], record), "fill: 14 200 steps (1.42 ms), settled.");
    record.settled = false;
    EXPECT_EQ(stage_ending(scene_.stages[0], record),
              "fill: 14 200 steps (1.42 ms), not at rest yet when its settle_time was over.");
    record.steps = 1;
    EXPECT_EQ(stage_ending({"run", "fill", {{{}, {}, 1, {}}}}, record), "fill: 1 step (1.42 ms).");
}

TEST(ListOf, ReadsLikeASentence) {
    EXPECT_EQ(list_of({"a"}), "a");
    EXPECT_EQ(list_of({"a", "b"}), "a and b");
    EXPECT_EQ(list_of({"a", "b", "c"}), "a, b and c");
    EXPECT_EQ(list_of({"a", "b", "c", "d"}), "a and 3 more");
}

}  // namespace
}  // namespace recoat
