#include <string>

#include <gtest/gtest.h>

#include "tests/stress/tally.hpp"

namespace recoat::stress {
namespace {

Tally of(int finished, int stopped, int refused) {
    Tally tally;
    const auto add = [&](Outcome outcome, int count) {
        for (int k = 0; k < count; ++k) tally.add(0, {}, {outcome, "", 0, 0, 0});
    };
    add(Outcome::finished, finished);
    add(Outcome::stopped, stopped);
    add(Outcome::refused, refused);
    return tally;
}

std::string complaint(int finished, int stopped, int refused) {
    return of(finished, stopped, refused).one_sided().value_or("");
}

TEST(Tally, OfTheUsualSharesIsNotOneSided) {
    EXPECT_EQ(complaint(1090, 715, 595), "");
    EXPECT_EQ(complaint(16, 26, 18), "");
}

TEST(Tally, WhereAllIsRefusedIsOneSided) {
    EXPECT_EQ(complaint(0, 0, 60),
              "0 of 60 scenes finished, a fifth at least expected: the draw, or what refuses scenes, has gone astray");
    EXPECT_NE(complaint(14, 10, 36).find("36 of 60 scenes refused"), std::string::npos);
    EXPECT_EQ(complaint(15, 15, 30), "");
}

TEST(Tally, WhereHardlyAnyFinishesIsOneSided) {
    EXPECT_NE(complaint(11, 30, 19).find("11 of 60 scenes finished"), std::string::npos);
    EXPECT_EQ(complaint(12, 30, 18), "");
}

TEST(Tally, WhereHardlyAnyStopsIsOneSided) {
    EXPECT_NE(complaint(40, 4, 16).find("4 of 60 scenes stopped"), std::string::npos);
    EXPECT_EQ(complaint(39, 5, 16), "");
}

// One scene that is drawn again says nothing of shares.
TEST(Tally, OfFewScenesSaysNothing) {
    EXPECT_EQ(complaint(0, 0, 39), "");
    EXPECT_NE(complaint(0, 0, 40), "");
}

TEST(Tally, CountsWhatIsWrong) {
    Tally tally = of(20, 15, 10);
    EXPECT_EQ(tally.failures(), 0);
    for (const Outcome outcome : {Outcome::crash, Outcome::hang, Outcome::bad_sentence, Outcome::no_state,
                                  Outcome::not_finite, Outcome::lost, Outcome::open_ledger})
        tally.add(1, {}, {outcome, "why", 0, 0, 0});
    EXPECT_EQ(tally.failures(), 7);
}

}  // namespace
}  // namespace recoat::stress
