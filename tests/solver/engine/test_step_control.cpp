#include <limits>

#include <gtest/gtest.h>

#include "solver/engine/step_plan.hpp"

namespace recoat {
namespace {

StepControl running() {
    StepControl control;
    control.target = 10;
    control.margin = 1;
    return control;
}

TEST(StepGate, ClosesBehindAFault) {
    StepControl control = running();
    const auto open = [&](StepStage stage) { return StepGate{&control, 0.25, stage}.open(); };
    control.peak[0] = 0.25;
    EXPECT_TRUE(open(StepStage::contacts));
    EXPECT_TRUE(open(StepStage::forces));
    EXPECT_TRUE(open(StepStage::attraction));
    control.peak[1] = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(open(StepStage::forces));
    EXPECT_FALSE(open(StepStage::attraction));
    control.peak[0] = 0.26;
    EXPECT_TRUE(open(StepStage::contacts)) << "the stage that measures it";
    EXPECT_FALSE(open(StepStage::forces));
    control = running();
    control.halt = Halt::target;
    EXPECT_FALSE(open(StepStage::contacts));
}

TEST(StepEnd, CountsTheStepAndItsWay) {
    StepControl control = running();
    control.margin = 2;
    const StepEnd end{&control, 0.1, 0.25, false};
    control.peak[0] = 0.2;
    control.peak[1] = 4;
    control.wall_speed = 1;
    end();
    EXPECT_TRUE(end.running());
    EXPECT_EQ(control.step, 1);
    EXPECT_DOUBLE_EQ(control.last_travel, 0.2);
    EXPECT_DOUBLE_EQ(control.largest_overlap, 0.2);
    EXPECT_EQ(control.peak[0] + control.peak[1], 0) << "ready for the next step";
    control.wall_speed = 3;
    end();
    EXPECT_DOUBLE_EQ(control.travelled, 0.2 + 0.3);
    EXPECT_EQ(control.halt, Halt::stale) << "2 (0.5 + 2 * 0.3) > 2";
}

TEST(StepEnd, AFaultIsNoStep) {
    for (const bool cohesive : {false, true}) {
        StepControl control = running();
        control.peak[0] = 0.3;
        StepEnd{&control, 0.1, 0.25, cohesive}();
        EXPECT_EQ(control.halt, Halt::deep);
        EXPECT_EQ(control.step, 0);
        control = running();
        control.peak[cohesive ? 2 : 1] = std::numeric_limits<double>::infinity();
        StepEnd{&control, 0.1, 0.25, cohesive}();
        EXPECT_EQ(control.halt, Halt::fast);
        EXPECT_EQ(control.step, 0);
    }
}

TEST(StepEnd, StopsAtTheTarget) {
    StepControl control = running();
    control.step = 9;
    StepEnd{&control, 0.1, 0.25, false}();
    EXPECT_EQ(control.halt, Halt::target);
    EXPECT_EQ(control.step, 10);
}

TEST(PlannedSteps, AreThoseTheListLastsAndALittleMore) {
    StepControl control;
    control.step = 100;
    control.target = 100000;
    control.margin = 1;
    EXPECT_EQ(planned_steps(control), 99900) << "nothing moves";
    control.last_travel = 0.001;
    const std::int64_t planned = planned_steps(control);
    // Steps until 2 (travelled + 2 last) > margin at this speed: 499.
    EXPECT_GE(planned, 499);
    EXPECT_LT(planned, 540);
    control.travelled = 10;
    EXPECT_GE(planned_steps(control), 1) << "there is always a step to make";
    control.target = 101;
    EXPECT_EQ(planned_steps(control), 1);
}

}  // namespace
}  // namespace recoat
