#include <algorithm>

#include <gtest/gtest.h>

#include "solver/engine/tile_plan.hpp"

namespace recoat {
namespace {

constexpr std::size_t awake = 5000, particles = 200000, numbers = 8;

/// A row of particles, each with the next as its partner and with two sleepers from all over the others.
Snapshot row_among_sleepers() {
    Snapshot s;
    s.particles.resize(particles);
    s.awake = awake;
    s.contacts.offsets.push_back(0);
    for (std::size_t i = 0; i < awake; ++i) {
        if (i + 1 < awake) s.contacts.second.push_back(static_cast<std::int32_t>(i + 1));
        for (const std::size_t sleeper : {awake + 7 * i, particles - 1 - i})
            s.contacts.second.push_back(static_cast<std::int32_t>(sleeper));
        s.contacts.offsets.push_back(static_cast<std::int32_t>(s.contacts.second.size()));
    }
    return s;
}

// What moves beside what sleeps costs no memory of those that sleep, and nobody waits for their sums.
TEST(TilePlan, DoesNotReachOutForSleepers) {
    TilePlan plan;
    plan.make(row_among_sleepers(), numbers);
    ASSERT_GT(plan.parts().size(), 1u);
    std::size_t end = 0;
    for (std::size_t p = 0; p < plan.parts().size(); ++p) {
        const TilePart& part = plan.parts()[p];
        EXPECT_EQ(part.particles.begin, end);
        end = part.particles.end;
        const bool is_last = p + 1 == plan.parts().size();
        EXPECT_EQ(part.reached.size(), is_last ? 0u : 1u) << "its last particle reaches the next part";
        EXPECT_EQ(part.sums.size(), numbers * (part.reached.size() + 1)) << "and one place for all sleepers";
        EXPECT_EQ(part.first_before, p == 0 ? 0 : p - 1);
    }
    EXPECT_EQ(end, awake);
    EXPECT_LT(plan.sums().size(), 2 * numbers * awake);
    ASSERT_EQ(plan.second_sums().size(), 3 * awake - 1);
    const TilePart& first = plan.parts().front();
    const auto place = [&](std::size_t k) { return static_cast<std::size_t>(plan.second_sums()[k]); };
    EXPECT_EQ(place(0), 1u) << "in its own place";
    const std::size_t own = awake, last = 3 * (first.particles.end - 1);
    EXPECT_EQ(place(last), own) << "the first of the next part";
    EXPECT_EQ(place(last + 1), own + 1) << "a sleeper, ...";
    EXPECT_EQ(place(last + 2), own + 1) << "... and another";
    EXPECT_EQ(place(1), own + 1);
    EXPECT_EQ(first.sums.data(), plan.sums().data() + numbers * own);
}

/// Every particle with one that is `step` places later.
Snapshot far_partners(std::size_t step) {
    Snapshot s;
    s.particles.resize(awake);
    s.awake = awake;
    s.contacts.offsets.push_back(0);
    for (std::size_t i = 0; i < awake; ++i) {
        if (i + step < awake) s.contacts.second.push_back(static_cast<std::int32_t>(i + step));
        s.contacts.offsets.push_back(static_cast<std::int32_t>(s.contacts.second.size()));
    }
    return s;
}

// Only what is reached has a place, however far away it is.
TEST(TilePlan, HasPlacesForThoseReachedOnly) {
    TilePlan plan;
    const std::size_t step = awake - 10;
    plan.make(far_partners(step), numbers);
    const TilePart& first = plan.parts().front();
    ASSERT_EQ(first.reached.size(), 10u);
    EXPECT_TRUE(std::is_sorted(first.reached.begin(), first.reached.end()));
    for (std::size_t i = 0; i < 10; ++i) {
        EXPECT_EQ(first.reached[i], static_cast<std::int32_t>(i + step));
        EXPECT_EQ(plan.second_sums()[i], static_cast<std::int32_t>(awake + i));
    }
    EXPECT_EQ(plan.parts().back().first_before, 0u);
}

}  // namespace
}  // namespace recoat
