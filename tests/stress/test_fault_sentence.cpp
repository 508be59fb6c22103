#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/stress/fault_sentence.hpp"

namespace recoat::stress {
namespace {

const std::string start = "recoat-solve: error: step 7 (t = 1.4e-07 s): ";
const std::string end = ". The state of the moment before is in /tmp/out/fault.vtkhdf.\n";
const std::string overlap_cause =
    ", more than 0.25 of the smallest radius; the time step is too large, the start too dense, or a wall too fast: "
    "reduce time_step, or move the particles apart";
const std::string speed_cause =
    "would be faster than 2.1 m/s, 0.05 of the smallest radius per step, or its velocity is not a number; reduce "
    "time_step, or check the velocities given";
const std::string energy_start =
    "energy appears: 3.1e-10 J, 0.48 of all energy exchanged since the start and more than 0.1 of it, are not "
    "accounted "
    "for; the time step is too large for the contacts (";

/// Three spheres of 25 um in a period of 200 um: 0 and 2 overlap by 10 um, across the period.
State three() {
    State state;
    state.step = 7;
    state.id = {0, 1, 2};
    state.radius.assign(3, 25e-6);
    state.position = {{0, 10e-6, 0}, {0, 100e-6, 0}, {0, 170e-6, 0}};
    return state;
}

/// What is wrong with the sentence of that `middle`, in a scene with a floor; empty: nothing.
std::string problem(const std::string& middle) {
    return unusable(start + middle + end, three(), {"floor", "blade"}, 200e-6).value_or("");
}

const std::string no_sentence = "it is none of the sentences about a fault";

TEST(FaultSentence, OfAnOverlapNamesBothAndTheyOverlap) {
    EXPECT_EQ(problem("particle 0 overlaps particle 2 by 1e-05 m" + overlap_cause), "");
    EXPECT_EQ(problem("particle 2 overlaps particle 0 by 1.2e-05 m" + overlap_cause), "");  // it came in the step
    EXPECT_EQ(problem("particle 1 overlaps wall 'blade' by 1e-05 m" + overlap_cause), "");
}

TEST(FaultSentence, OfAnOverlapWithoutPartnerIsRefused) {
    EXPECT_EQ(problem("particle 0 overlaps by 1e-05 m" + overlap_cause), no_sentence);
    EXPECT_EQ(problem("particle 0 overlaps something by 1e-05 m" + overlap_cause), no_sentence);
    EXPECT_EQ(problem("particle 0 overlaps particle by 1e-05 m" + overlap_cause), no_sentence);
    EXPECT_EQ(problem("particle 0 overlaps wall '' by 1e-05 m" + overlap_cause), no_sentence);
}

TEST(FaultSentence, OfPartnersThatAreNotThereIsRefused) {
    EXPECT_EQ(problem("particle 3 overlaps particle 0 by 1e-05 m" + overlap_cause), "there is no particle 3");
    EXPECT_EQ(problem("particle 0 overlaps particle 9 by 1e-05 m" + overlap_cause), "there is no particle 9");
    EXPECT_EQ(problem("particle 0 overlaps wall 'lid' by 1e-05 m" + overlap_cause), "there is no wall lid");
    EXPECT_EQ(problem("particle 0 overlaps particle 0 by 1e-05 m" + overlap_cause), "a particle is its own partner");
}

TEST(FaultSentence, OfAPairThatDoesNotOverlapSoIsRefused) {
    EXPECT_NE(problem("particle 0 overlaps particle 1 by 1e-05 m" + overlap_cause), "");
    EXPECT_NE(problem("particle 0 overlaps particle 2 by 2e-05 m" + overlap_cause), "");
    EXPECT_NE(problem("particle 0 overlaps particle 2 by 1e-06 m" + overlap_cause), "");
}

TEST(FaultSentence, OfEnergyNamesBothOfTheStiffestContact) {
    const std::string stiffest = energy_start + "the stiffest contact now is that of particle 1 and ";
    const std::string rest = ", of frequency w with w dt = 8.24): reduce time_step";
    EXPECT_EQ(problem(stiffest + "particle 2" + rest), "");
    EXPECT_EQ(problem(stiffest + "wall 'floor'" + rest), "");
    EXPECT_EQ(problem(stiffest + "wall 'lid'" + rest), "there is no wall lid");
    EXPECT_EQ(problem(stiffest + "particle 1" + rest), "a particle is its own partner");
    EXPECT_EQ(problem(energy_start + "the stiffest contact now is that of particle 1" + rest), no_sentence);
    EXPECT_EQ(problem(energy_start + "nothing touches now, and particle 1 is the fastest): reduce time_step"), "");
}

TEST(FaultSentence, OfSpeedAndPlaceNamesTheParticle) {
    EXPECT_EQ(problem("particle 1 " + speed_cause), "");
    EXPECT_EQ(problem("particle 4 " + speed_cause), "there is no particle 4");
    EXPECT_EQ(problem("something " + speed_cause), no_sentence);
    EXPECT_EQ(problem("particle 1 at (1, -2e-05, 0) m has left the domain; add a wall there, or enlarge the domain"),
              "");
}

TEST(FaultSentence, WithoutStepCauseRemedyOrStateIsRefused) {
    const auto read = [](const std::string& sentence) { return read_fault_sentence(sentence).has_value(); };
    const std::string middle = "particle 1 " + speed_cause;
    EXPECT_TRUE(read(start + middle + end));
    EXPECT_FALSE(read("recoat-solve: error: " + middle + end));
    EXPECT_FALSE(read(start + middle + "\n"));
    EXPECT_FALSE(read(start + "particle 1 is wrong" + end));
    EXPECT_FALSE(read(start + "particle 1 would be faster than 2.1 m/s, much" + end));
    EXPECT_FALSE(
        read(start + middle + " The state of the moment before is in /tmp/out/fault.vtkhdf.\n"));  // no full stop
    EXPECT_FALSE(read(start + middle + end + "more\n"));
}

TEST(FaultSentence, OfAnotherStepThanItsStateIsRefused) {
    State state = three();
    state.step = 8;
    EXPECT_EQ(unusable(start + "particle 1 " + speed_cause + end, state, {}, 0).value_or(""), "the state is of step 8");
}

}  // namespace
}  // namespace recoat::stress
