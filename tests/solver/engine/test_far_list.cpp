#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "solver/engine/far_list.hpp"
#include "solver/engine/snapshot.hpp"
#include "solver/engine/spatial_sort.hpp"

namespace recoat {
namespace {

using PairSet = std::set<std::pair<std::int32_t, std::int32_t>>;

std::vector<Row> scattered(std::size_t count, Vec3 size, double y_min, unsigned seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<Row> rows(count);
    for (Row& row : rows)
        row = {size.x * unit(random), y_min + size.y * unit(random), size.z * unit(random), 0.3 + 0.2 * unit(random)};
    return rows;
}

/// Every pair within the skin, by looking at all of them and at all images in y.
PairSet all_pairs(const std::vector<Row>& rows, double skin, double period) {
    PairSet found;
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (std::size_t j = i + 1; j < rows.size(); ++j)
            for (const double shift : {-1.0, 0.0, 1.0}) {
                Vec3 d = rows[j].xyz() - rows[i].xyz();
                d.y += shift * period;
                if (norm(d) - rows[i].w - rows[j].w < skin)
                    found.insert({static_cast<std::int32_t>(i), static_cast<std::int32_t>(j)});
            }
    return found;
}

/// Particles at `rows`, named in this order, sorted as the engine does.
Particles sorted_in_space(const std::vector<Row>& rows, const std::vector<std::int64_t>& id, double skin, double y_min,
                          double period) {
    Particles particles;
    particles.resize(rows.size());
    particles.position = rows;
    particles.id = id;
    for (std::size_t i = 0; i < rows.size(); ++i) particles.velocity[i] = row({rows[i].x, rows[i].z, 7});
    OpenMP space(1);
    SpatialSort<OpenMP> sort;
    sort(space, particles, skin, y_min, period);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_EQ(particles.id[i], id[static_cast<std::size_t>(sort.order()[i])]);
        EXPECT_EQ(particles.velocity[i].x, particles.position[i].x) << "rows must stay together";
    }
    return particles;
}

std::vector<std::int64_t> counted(std::size_t n) {
    std::vector<std::int64_t> id(n);
    std::iota(id.begin(), id.end(), 0);
    return id;
}

/// Sorts as the engine does, builds, and compares.
void expect_complete(const std::vector<Row>& rows, double skin, double y_min, double period) {
    const std::vector<Row> sorted = sorted_in_space(rows, counted(rows.size()), skin, y_min, period).position;
    for (const int threads : {1, 3}) {
        OpenMP space(threads);
        FarList<OpenMP> list;
        list.build(space, sorted, sorted.size(), skin, y_min, period);
        PairSet found;
        for (std::size_t i = 0; i < sorted.size(); ++i) {
            EXPECT_TRUE(std::is_sorted(list.second.begin() + list.begin[i], list.second.begin() + list.begin[i + 1]));
            for (std::int32_t e = list.begin[i]; e < list.begin[i + 1]; ++e)
                found.insert({static_cast<std::int32_t>(i), list.second[static_cast<std::size_t>(e)]});
        }
        EXPECT_EQ(found.size(), list.second.size()) << "a pair is listed twice";
        EXPECT_EQ(found, all_pairs(sorted, skin, period));
    }
}

TEST(FarList, FindsEveryPairWithoutAPeriod) {
    for (unsigned seed = 0; seed < 4; ++seed) {
        expect_complete(scattered(400, {8, 8, 8}, -3, seed), 0.2, 0, 0);
        expect_complete(scattered(200, {40, 2, 2}, 5, seed), 0.2, 0, 0);
        expect_complete(scattered(200, {1, 1, 90}, 0, seed), 0.2, 0, 0);
    }
}

// A cell is a largest diameter and a skin wide, here about 1.2.
TEST(FarList, FindsEveryPairThroughThePeriod) {
    const double two_cells = 2.5, three_cells = 3.7, many_cells = 11.3;
    for (unsigned seed = 10; seed < 14; ++seed)
        for (const double period : {two_cells, three_cells, many_cells})
            for (const double y_min : {0.0, -1.7, 100.0})
                expect_complete(scattered(250, {6, period, 4}, y_min, seed), 0.2, y_min, period);
}

TEST(FarList, FindsPairsAmongLonersInAWideDomain) {
    std::vector<Row> rows = scattered(100, {1e5, 1e5, 1e5}, 0, 20);
    for (std::size_t i = 0; i < 40; ++i) {
        Row twin = rows[i];
        twin.x += 0.7;
        rows.push_back(twin);
    }
    expect_complete(rows, 0.2, 0, 0);
    EXPECT_EQ(all_pairs(rows, 0.2, 0).size(), 40u);
}

TEST(FarList, HandlesNoneAndOne) {
    expect_complete({}, 0.2, 0, 0);
    expect_complete({}, 0.2, 0, 5);
    expect_complete({{1, 2, 3, 0.5}}, 0.2, 0, 5);
}

// Sleepers come last, each part in spatial order.
TEST(FarList, FindsEveryPairOfTheAwakeAndOfSleepers) {
    for (unsigned seed = 40; seed < 44; ++seed)
        for (const double period : {2.5, 11.3}) {
            const std::vector<Row> rows = scattered(300, {6, period, 4}, 0, seed);
            Particles particles;
            particles.resize(rows.size());
            particles.position = rows;
            particles.id = counted(rows.size());
            std::vector<std::int32_t> asleep(rows.size());
            for (std::size_t i = 0; i < rows.size(); ++i) asleep[i] = rows[i].x > 2 && i % 5 != 0 ? 1 : 0;
            const auto sleepers = static_cast<std::size_t>(std::accumulate(asleep.begin(), asleep.end(), 0));
            OpenMP space(2);
            SpatialSort<OpenMP> sort;
            sort(space, particles, 0.2, 0, period, asleep.data());
            FarList<OpenMP> list;
            list.build(space, particles.position, rows.size() - sleepers, 0.2, 0, period);
            PairSet found;
            for (std::size_t i = 0; i < rows.size(); ++i) {
                EXPECT_EQ(asleep[static_cast<std::size_t>(sort.order()[i])] == 1, i >= rows.size() - sleepers);
                EXPECT_TRUE(
                    std::is_sorted(list.second.begin() + list.begin[i], list.second.begin() + list.begin[i + 1]));
                for (std::int32_t e = list.begin[i]; e < list.begin[i + 1]; ++e)
                    found.insert({static_cast<std::int32_t>(i), list.second[static_cast<std::size_t>(e)]});
            }
            EXPECT_EQ(found.size(), list.second.size()) << "a pair is listed twice";
            EXPECT_EQ(found, all_pairs(particles.position, 0.2, period));
        }
}

TEST(SpatialOrder, IsAPermutationThatDoesNotDependOnTheOrderGiven) {
    const std::vector<Row> rows = scattered(300, {5, 5, 5}, 0, 30);
    std::vector<std::size_t> shuffled(rows.size());
    for (std::size_t i = 0; i < shuffled.size(); ++i) shuffled[i] = i;
    std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937_64(31));
    std::vector<Row> other;
    std::vector<std::int64_t> other_id;
    for (const std::size_t i : shuffled) {
        other.push_back(rows[i]);
        other_id.push_back(static_cast<std::int64_t>(i));
    }
    const Particles sorted = sorted_in_space(rows, counted(rows.size()), 0.2, 0, 5);
    EXPECT_EQ(std::set<std::int64_t>(sorted.id.begin(), sorted.id.end()).size(), rows.size());
    EXPECT_EQ(sorted.id, sorted_in_space(other, other_id, 0.2, 0, 5).id);
}

TEST(Fold, BringsEveryYIntoThePeriod) {
    for (const double y : {-1e-20, -7.3, 0.0, 4.999999, 5.0, 12.5, 1e6}) {
        const double inside = folded(y, 0, 5);
        EXPECT_GE(inside, 0) << y;
        EXPECT_LT(inside, 5) << y;
        EXPECT_NEAR(std::remainder(y - inside, 5), 0, 1e-9) << y;
    }
    EXPECT_EQ(folded(-3, 0, 0), -3);
}

}  // namespace
}  // namespace recoat
