#include <functional>
#include <thread>

#include <gtest/gtest.h>

#include "common/hdf5.hpp"
#include "common/state.hpp"
#include "tests/support/temporary_folder.hpp"

namespace recoat {
namespace {

constexpr int threads = 4;

/// Runs `body(0) ... body(threads - 1)` at the same time.
void at_once(const std::function<void(int)>& body) {
    std::vector<std::jthread> running;
    for (int thread = 0; thread < threads; ++thread) running.emplace_back([&body, thread] { body(thread); });
}

std::vector<double> numbers(std::size_t count, int thread, int round) {
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i) values[i] = static_cast<double>(i) + 0.25 * thread + 1000 * round;
    return values;
}

State state_of(int thread, int round) {
    State state;
    state.step = round;
    state.radius = numbers(50, thread, round);
    for (const double value : state.radius) {
        state.id.push_back(static_cast<std::int64_t>(state.id.size()));
        state.position.push_back({value, thread + value, 2 * value});
        state.velocity.push_back({-value, 0, 1});
        state.angular_velocity.push_back({0, value, round - value});
    }
    return state;
}

// Exceptions must not leave a thread.
template <class Action>
void expect_good(const Action& action) {
    try {
        action();
    } catch (const std::exception& error) {
        ADD_FAILURE() << error.what();
    }
}

TEST(Hdf5Threads, FilesAreWrittenAndReadAtTheSameTime) {
    const testing::TemporaryFolder folder;
    at_once([&](int thread) {
        const std::filesystem::path path = folder / (std::to_string(thread) + ".h5");
        for (int round = 0; round < 200; ++round) {
            expect_good([&] {
                const std::vector<double> values = numbers(100, thread, round);
                {
                    const auto file = hdf5::File::create(path);
                    const auto group = file.create_group("group");
                    group.set_attribute("round", std::int64_t{round});
                    group.write("values", values, {}, true);
                    group.create_extendible<double>("rows", {}, 16).append(values);
                }
                const auto group = hdf5::File::open(path).group("group");
                EXPECT_EQ(group.integer_attribute("round"), round);
                EXPECT_EQ(group.read<double>("values"), values);
                EXPECT_EQ(group.read<double>("rows"), values);
                EXPECT_EQ(group.names(), (std::vector<std::string>{"rows", "values"}));
            });
        }
    });
}

TEST(Hdf5Threads, StatesAreWrittenAndReadAtTheSameTime) {
    const testing::TemporaryFolder folder;
    at_once([&](int thread) {
        const std::filesystem::path path = folder / (std::to_string(thread) + ".vtkhdf");
        for (int round = 0; round < 10; ++round) {
            expect_good([&] {
                const State state = state_of(thread, round);
                write_state(path, {}, state);
                const State read = read_state(path);
                EXPECT_EQ(read.step, round);
                EXPECT_EQ(read.position, state.position);
                EXPECT_EQ(read.radius, state.radius);
            });
        }
    });
}

TEST(Hdf5Threads, AFileIsClosedByAnotherThreadThanTheOneThatOpenedIt) {
    const testing::TemporaryFolder folder;
    auto file = hdf5::File::create(folder / "a.h5");
    std::jthread([file = std::move(file)]() mutable {
        file.write("a", std::vector<double>{1, 2});
        file.close();
    }).join();
    EXPECT_EQ(hdf5::File::open(folder / "a.h5").read<double>("a"), (std::vector<double>{1, 2}));
}

}  // namespace
}  // namespace recoat
