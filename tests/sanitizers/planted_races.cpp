#include <algorithm>
#include <chrono>
#include <numeric>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include "solver/execution/openmp.hpp"
#include "tests/sanitizers/expect_finding.hpp"

// Races made on purpose, and the same loops without: a clean run of all other tests says something only if the former
// are seen, and the latter not reported.

namespace {

using recoat::OpenMP;
using recoat::testing::expect_finding;

constexpr std::size_t n = 100000;

/// Every iteration reads its neighbour, which at the limit of a block is written by another thread.
void race_of_openmp() {
    std::vector<double> values(n + 1, 1.0);
    OpenMP{2}.for_each(n, [&](std::size_t k) { values[k] = values[k + 1]; });
}

/// The same of the loop that is a vector loop elsewhere.
struct VectorLoop {
    static constexpr bool vector = true;
    double* values;
    double* peak;

    [[nodiscard]] static bool open() { return true; }
    template <class Call>
    void segments(const Call& call) const {
        call([to = values](std::size_t k) { return to[k] = to[k + 1]; }, n);
    }
};

void race_of_vector_loop() {
    std::vector<double> values(n + 1, 1.0);
    double peak = 0;
    OpenMP{2}.run(VectorLoop{values.data(), &peak});
}

/// Long enough that a second thread takes a part, on any machine.
void wait_a_little() { std::this_thread::sleep_for(std::chrono::microseconds(10)); }

void race_of_tbb() {
    const tbb::global_control two(tbb::global_control::max_allowed_parallelism, 2);
    int last = 0;
    tbb::parallel_for(0, 1000, [&](int k) {
        wait_a_little();
        last = k;
    });
}

void race_of_threads() {
    int value = 0;
    std::jthread other([&] { value = 1; });
    value = 2;
}

TEST(Planted, RaceInALoopOfOpenMP) { expect_finding(race_of_openmp, "data race"); }
TEST(Planted, RaceInAVectorLoop) { expect_finding(race_of_vector_loop, "data race"); }
TEST(Planted, RaceInALoopOfTBB) { expect_finding(race_of_tbb, "data race"); }
TEST(Planted, RaceOfThreads) { expect_finding(race_of_threads, "data race"); }

TEST(NoRace, LoopsOfOpenMPThatFollowEachOther) {
    std::vector<double> values(n, 1.0);
    const OpenMP threads{2};
    for (int round = 0; round < 20; ++round) {
        threads.for_each(n, [&](std::size_t k) { values[k] += 1; });
        threads.for_each(n, [&](std::size_t k) { values[n - 1 - k] += 1; });
    }
    EXPECT_EQ(threads.sum(n, [&](std::size_t k) { return values[k]; }), 41.0 * n);
}

TEST(NoRace, LoopsOfTBBThatFollowEachOther) {
    const tbb::global_control two(tbb::global_control::max_allowed_parallelism, 2);
    std::vector<int> values(1000, 1);
    for (int round = 0; round < 20; ++round) {
        tbb::parallel_for(0, 1000, [&](int k) {
            if (k % 100 == 0) wait_a_little();
            ++values[static_cast<std::size_t>(k)];
        });
        tbb::parallel_for(0, 1000, [&](int k) { ++values[static_cast<std::size_t>(999 - k)]; });
    }
    EXPECT_EQ(std::accumulate(values.begin(), values.end(), 0), 41000);
}

TEST(NoRace, SortOfTBB) {
    const tbb::global_control two(tbb::global_control::max_allowed_parallelism, 2);
    std::vector<unsigned> values(n);
    unsigned number = 1;
    for (unsigned& value : values) value = number = number * 1664525U + 1013904223U;
    tbb::parallel_sort(values.begin(), values.end());
    EXPECT_TRUE(std::ranges::is_sorted(values));
}

}  // namespace
