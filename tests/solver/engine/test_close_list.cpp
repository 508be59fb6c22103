#include <map>
#include <optional>
#include <set>

#include <gtest/gtest.h>

#include "solver/engine/close_list.hpp"
#include "solver/engine/snapshot.hpp"
#include "solver/engine/spatial_sort.hpp"
#include "tests/solver/engine/engine_scenes.hpp"

namespace recoat {
namespace {

using testing::box;
using testing::dp;
using testing::infinite;
using testing::plane;
using testing::random_packing;

constexpr double period = 8 * dp, range = 0.1 * dp;

struct Bed {
    Particles particles;
    std::vector<Row>& position = particles.position;
    double skin = 0.3 * dp;
    std::vector<Wall> walls = {plane("base", {}, {0, 0, 1}),
                               box("bar", {2 * dp, -infinite, 3 * dp}, {3 * dp, infinite, 4 * dp})};
    OpenMP space{2};

    explicit Bed(unsigned seed) {
        const ParticleTable table = random_packing(500, {10 * dp, period, 10 * dp}, 0.7, true, seed);
        particles = initial_snapshot(table, {}).particles;
        sort(skin);
    }

    /// Puts the particles into another order; returns where each was before.
    std::vector<std::int32_t> sort(double other_skin) {
        skin = other_skin;
        SpatialSort<OpenMP> sort;
        sort(space, particles, skin, 0, period);
        return sort.order();
    }

    /// `old_place`: where each particle was in `old`; none: where it is now.
    Contacts list(const std::optional<Contacts>& old = {}, double within = range,
                  const std::vector<std::int32_t>& old_place = {}) {
        FarList<OpenMP> far;
        far.build(space, position, position.size(), skin, 0, period);
        const auto anchors = MovingWalls(walls).anchors();
        ContactHistory<OpenMP> history;
        Contacts made = old.value_or(empty());
        history.awake.take(space, made, 0, position.size());
        make_close_list(space,
                        {position.data(), 0, position.size(), anchors.data(), anchors.size(), 0, 1e-7, period, within,
                         old_place.empty() ? nullptr : old_place.data()},
                        far, history, made);
        list_incidence(space, made, position.size(), position.size());
        return made;
    }

    [[nodiscard]] Contacts empty() const {
        Contacts none;
        none.offsets.assign(position.size() * (1 + walls.size()) + 1, 0);
        return none;
    }
};

using Key = std::pair<std::int32_t, std::int32_t>;

Key key(const Contacts& c, std::size_t k) { return {c.first[k], c.second[k]}; }

/// Pairs and walls within `within`, by looking at all of them.
std::set<Key> all_contacts(const Bed& bed, double within) {
    std::set<Key> found;
    for (std::size_t i = 0; i < bed.position.size(); ++i) {
        const Row& p = bed.position[i];
        for (std::size_t j = i + 1; j < bed.position.size(); ++j) {
            Vec3 d = bed.position[j].xyz() - p.xyz();
            d.y -= period * std::round(d.y / period);
            if (norm(d) < p.w + bed.position[j].w + within)
                found.insert({static_cast<std::int32_t>(i), static_cast<std::int32_t>(j)});
        }
        if (p.z - p.w < within) found.insert({static_cast<std::int32_t>(i), -1});
        const double dx = std::max({2 * dp - p.x, p.x - 3 * dp, 0.0}), dz = std::max({3 * dp - p.z, p.z - 4 * dp, 0.0});
        if (std::hypot(dx, dz) - p.w < within) found.insert({static_cast<std::int32_t>(i), -2});
    }
    return found;
}

void mark(Contacts& c) {
    for (std::size_t k = 0; k < c.size(); ++k) {
        c.slip_x[k] = static_cast<double>(k) + 0.25;
        c.slip_y[k] = -static_cast<double>(k);
        c.slip_z[k] = 1.0 / static_cast<double>(k + 1);
        c.attraction[k] = static_cast<double>(k) + 0.5;
        c.lost_normal[k] = 1;
    }
}

TEST(CloseList, HoldsEveryPairAndWallWithinRange) {
    for (unsigned seed = 1; seed < 4; ++seed) {
        Bed bed(seed);
        const Contacts made = bed.list();
        std::set<Key> found;
        for (std::size_t k = 0; k < made.size(); ++k) found.insert(key(made, k));
        EXPECT_EQ(found.size(), made.size());
        EXPECT_EQ(found, all_contacts(bed, range));
        ASSERT_EQ(made.wall_begin.size(), 3u);
        EXPECT_EQ(made.wall_begin.front(), made.pairs);
        EXPECT_EQ(made.wall_begin.back(), made.size());
        EXPECT_GT(made.wall_begin[1], made.wall_begin[0]);
        EXPECT_GT(made.wall_begin[2], made.wall_begin[1]);
    }
}

TEST(CloseList, IncidenceNamesEveryContactOfAParticleInOrder) {
    Bed bed(1);
    Contacts made = bed.list();
    list_incidence(bed.space, made, bed.position.size(), bed.position.size());
    std::size_t entries = 0;
    for (std::size_t i = 0; i < bed.position.size(); ++i) {
        const auto first = static_cast<std::size_t>(made.incidence_begin[i]);
        for (std::size_t e = first; e < static_cast<std::size_t>(made.incidence_begin[i + 1]); ++e, ++entries) {
            const std::int32_t entry = made.incidence[e];
            const auto k = static_cast<std::size_t>(entry / 2);
            ASSERT_EQ(entry % 2 ? made.second[k] : made.first[k], static_cast<std::int32_t>(i));
            ASSERT_TRUE(e == first || made.incidence[e - 1] / 2 < entry / 2);
        }
    }
    EXPECT_EQ(entries, 2 * made.pairs + (made.size() - made.pairs));
}

TEST(CloseList, InactiveWallsHaveNoContacts) {
    Bed bed(1);
    bed.walls[0].active = false;
    const Contacts made = bed.list();
    EXPECT_EQ(made.wall_begin[0], made.wall_begin[1]);
    EXPECT_LT(made.wall_begin[1], made.wall_begin[2]);
}

TEST(CloseList, HandsHistoryOver) {
    Bed bed(2);
    Contacts old = bed.list();
    mark(old);
    std::map<Key, std::size_t> place;
    for (std::size_t k = 0; k < old.size(); ++k) place[key(old, k)] = k;
    // First a wider list, with new contacts between the old ones; then a narrower one.
    for (const double within : {2 * range, 0.4 * range}) {
        const Contacts made = bed.list(old, within);
        std::size_t known = 0;
        for (std::size_t k = 0; k < made.size(); ++k) {
            const auto found = place.find(key(made, k));
            const bool is_known = found != place.end();
            known += is_known;
            ASSERT_EQ(made.slip(k), is_known ? old.slip(found->second) : Vec3{});
            ASSERT_EQ(made.attraction[k], is_known ? old.attraction[found->second] : 0);
            ASSERT_EQ(made.lost_normal[k], 0);
        }
        EXPECT_GT(known, 20u);
        EXPECT_EQ(known, within > range ? old.size() : made.size());
        EXPECT_EQ(made.size() > old.size(), within > range);
    }
}

// The displacement of a contact is that of its first relative to its second: whoever is first in the new order, the
// displacement of a given particle stays what it was.
TEST(CloseList, HistoryKeepsItsMeaningInAnotherOrder) {
    Bed bed(3);
    Contacts old = bed.list();
    mark(old);
    const std::vector<std::int32_t> old_place = bed.sort(0.9 * dp);
    const Contacts made = bed.list(old, range, old_place);
    ASSERT_EQ(made.size(), old.size());

    const auto displacement = [](const Contacts& c, std::size_t k, std::int32_t of) {
        return c.first[k] == of ? c.slip(k) : -c.slip(k);
    };
    std::map<Key, std::size_t> place;
    for (std::size_t k = 0; k < old.size(); ++k) place[key(old, k)] = k;
    std::size_t swapped_pairs = 0;
    for (std::size_t k = 0; k < made.size(); ++k) {
        const std::int32_t first = old_place[static_cast<std::size_t>(made.first[k])];
        const std::int32_t second =
            made.second[k] < 0 ? made.second[k] : old_place[static_cast<std::size_t>(made.second[k])];
        const bool swap = second >= 0 && first > second;
        const std::size_t from = place.at(swap ? Key{second, first} : Key{first, second});
        swapped_pairs += swap;
        ASSERT_EQ(displacement(made, k, made.first[k]), displacement(old, from, first));
        ASSERT_EQ(made.attraction[k], old.attraction[from]);
        ASSERT_TRUE(k >= made.pairs || made.first[k] < made.second[k]);
        ASSERT_TRUE(k == 0 || k >= made.pairs || key(made, k - 1) < key(made, k));
    }
    EXPECT_GT(swapped_pairs, 50u);
    EXPECT_LT(swapped_pairs, made.pairs);
}

TEST(CloseList, ThereAndBackIsAsBefore) {
    Bed bed(3);
    const double skin = bed.skin;
    Contacts old = bed.list();
    mark(old);
    const std::vector<std::int32_t> there = bed.sort(0.9 * dp);
    const Contacts other = bed.list(old, range, there);
    const std::vector<std::int32_t> back = bed.sort(skin);
    EXPECT_NE(back, there);
    const Contacts again = bed.list(other, range, back);
    EXPECT_EQ(again.first, old.first);
    EXPECT_EQ(again.second, old.second);
    EXPECT_EQ(again.slip_x, old.slip_x);
    EXPECT_EQ(again.slip_z, old.slip_z);
    EXPECT_EQ(again.attraction, old.attraction);
}

TEST(CloseList, OffsetsFollowFromTheContacts) {
    Bed bed(1);
    const Contacts made = bed.list();
    Contacts restored = made;
    restored.offsets.clear();
    list_offsets(bed.space, restored, 0, bed.position.size(), bed.walls.size());
    EXPECT_EQ(restored.offsets, made.offsets);
}

/// Some particles, who sleep: every third.
std::vector<std::int32_t> every_third(std::size_t n) {
    std::vector<std::int32_t> asleep(n);
    for (std::size_t i = 0; i < n; i += 3) asleep[i] = 1;
    return asleep;
}

// Two lists, of the awake and of sleepers among each other, hold together what one holds, and hand it over and back.
TEST(CloseList, OfTheAwakeAndOfSleepersAreTheListOfAll) {
    Bed bed(4);
    const std::size_t n = bed.position.size(), asleep = (n + 2) / 3, awake = n - asleep;
    Contacts whole = bed.list();
    mark(whole);
    const auto anchors = MovingWalls(bed.walls).anchors();
    SpatialSort<OpenMP> sort;
    FarList<OpenMP> far;
    ContactHistory<OpenMP> history;
    const auto make = [&](std::size_t begin, std::size_t count) {
        Contacts made;
        make_close_list(bed.space,
                        {bed.position.data(), begin, count, anchors.data(), anchors.size(), 0, 1e-7, period, range,
                         sort.order().data()},
                        far, history, made);
        return made;
    };
    history.awake.take(bed.space, whole, 0, n);
    sort(bed.space, bed.particles, bed.skin, 0, period, every_third(n).data());
    for (std::size_t i = 0; i < n; ++i) ASSERT_EQ(sort.order()[i] % 3 == 0, i >= awake) << i;
    far.build(bed.space, bed.position, awake, bed.skin, 0, period);
    const Contacts moving = make(0, awake), sleeping = make(awake, asleep);
    EXPECT_EQ(moving.size() + sleeping.size(), whole.size());
    EXPECT_GT(sleeping.pairs, 10u);
    for (std::size_t k = 0; k < sleeping.pairs; ++k)
        ASSERT_TRUE(sleeping.first[k] >= static_cast<std::int32_t>(awake) && sleeping.second[k] > sleeping.first[k]);
    for (std::size_t k = 0; k < moving.size(); ++k) ASSERT_LT(moving.first[k], static_cast<std::int32_t>(awake));

    Contacts offsets = sleeping;
    list_offsets(bed.space, offsets, awake, asleep, bed.walls.size());
    EXPECT_EQ(offsets.offsets, sleeping.offsets);

    history.awake.take(bed.space, moving, 0, awake);
    history.asleep.take(bed.space, sleeping, awake, asleep);
    sort(bed.space, bed.particles, bed.skin, 0, period);
    far.build(bed.space, bed.position, n, bed.skin, 0, period);
    const Contacts again = make(0, n);
    EXPECT_EQ(again.first, whole.first);
    EXPECT_EQ(again.second, whole.second);
    EXPECT_EQ(again.slip_x, whole.slip_x);
    EXPECT_EQ(again.slip_y, whole.slip_y);
    EXPECT_EQ(again.slip_z, whole.slip_z);
    EXPECT_EQ(again.attraction, whole.attraction);
}

// Relative rolling asks for the number of contacts of a sleeper, too.
TEST(CloseList, SleepersHaveNoIncidence) {
    Bed bed(1);
    Contacts made = bed.list();
    const std::size_t n = bed.position.size(), awake = n / 2;
    list_incidence(bed.space, made, awake, n);
    ASSERT_EQ(made.incidence_begin.size(), n + 1);
    for (std::size_t i = awake; i < n; ++i) ASSERT_EQ(made.incidence_begin[i + 1], made.incidence_begin[awake]);
    for (const std::int32_t entry : made.incidence) {
        const auto k = static_cast<std::size_t>(entry / 2);
        ASSERT_LT(entry % 2 ? made.second[k] : made.first[k], static_cast<std::int32_t>(awake));
    }
}

}  // namespace
}  // namespace recoat
