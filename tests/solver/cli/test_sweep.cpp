#include <chrono>
#include <condition_variable>
#include <csignal>
#include <fstream>
#include <list>
#include <mutex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solver/stop_request.hpp"
#include "solver/sweep.hpp"
#include "tests/support/fake_engine.hpp"
#include "tests/support/scene_text.hpp"
#include "tests/support/temporary_folder.hpp"

namespace recoat {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// Makes fake engines, each with a script of its own, for threads at the same time. The number of particles tells the
/// cases apart.
class Engines {
public:
    std::size_t fault_of = 0;        ///< number of particles of the case whose engine fails
    std::size_t bug_of = 0;          ///< of the case that meets a bug
    int wait_for = 1;                ///< an engine comes to be when there have been that many at the same time
    std::vector<std::size_t> order;  ///< particles of the engines made
    int most = 0;                    ///< engines at the same time

    EngineFactory factory() {
        return {[this](const EngineSetup& setup, const ParticleTable& particles, std::vector<Wall> walls) {
                    return make(setup, particles, std::move(walls));
                },
                [this](const EngineSetup& setup, const EngineState& state) {
                    return std::make_unique<FakeEngine>(new_script(), setup.time_step, state);
                }};
    }

private:
    using FakeEngine = testing::FakeEngine;

    struct Counted : FakeEngine {
        Counted(Engines& engines, testing::FakeScript& script, double step, ParticleTable particles,
                std::vector<Wall> walls)
            : FakeEngine(script, step, std::move(particles), std::move(walls)), engines_(engines) {}
        Counted(const Counted&) = delete;
        Counted& operator=(const Counted&) = delete;
        ~Counted() override {
            const std::lock_guard lock(engines_.mutex_);
            --engines_.now_;
        }
        Engines& engines_;
    };

    std::unique_ptr<Engine> make(const EngineSetup& setup, const ParticleTable& particles, std::vector<Wall> walls) {
        if (particles.size() == bug_of) throw std::logic_error("no such index");
        testing::FakeScript& script = new_script();
        if (particles.size() == fault_of) script.fault_at = 7;
        std::unique_lock lock(mutex_);
        order.push_back(particles.size());
        most = std::max(most, ++now_);
        changed_.notify_all();
        changed_.wait_for(lock, std::chrono::seconds(20), [&] { return most >= wait_for; });
        return std::make_unique<Counted>(*this, script, setup.time_step, particles, std::move(walls));
    }

    testing::FakeScript& new_script() {
        const std::lock_guard lock(mutex_);
        return scripts_.emplace_back();
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    std::list<testing::FakeScript> scripts_;
    int now_ = 0;
};

class Sweep : public ::testing::Test {
protected:
    /// Case `name` of that many particles.
    SweepCase one(const std::string& name, int particles) {
        const std::vector<std::string> settings = {"powder.particles=" + std::to_string(particles), "time_step=1e-6 s",
                                                   "output.energy_interval=1 ms", "output.trajectory_interval=50 ms"};
        return {name, folder_ / name, testing::scene_of(testing::spread_text, settings)};
    }
    std::vector<CaseEnding> sweep(const std::vector<SweepCase>& cases, int jobs, bool overwrite = false) {
        SweepOptions options;
        options.jobs = jobs;
        options.quiet = true;
        options.overwrite = overwrite;
        return run_sweep(cases, options, engines_.factory());
    }
    static std::vector<std::string> lines(const std::vector<CaseEnding>& endings) {
        std::vector<std::string> result;
        for (const CaseEnding& ending : endings) result.push_back(ending.name + ": " + ending.what);
        return result;
    }
    static std::string bytes(const fs::path& file) {
        std::ifstream stream(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }

    testing::TemporaryFolder folder_;
    Engines engines_;
};

TEST_F(Sweep, BeginsTheCasesInTheirOrder) {
    const auto endings = sweep({one("a", 20), one("b", 10), one("c", 30)}, 1);
    EXPECT_THAT(engines_.order, ElementsAre(20, 10, 30));
    EXPECT_THAT(lines(endings), ElementsAre("a: finished", "b: finished", "c: finished"));
    EXPECT_EQ(exit_code(endings), 0);
    EXPECT_EQ(engines_.most, 1);
}

TEST_F(Sweep, RunsAsManyAtTheSameTimeAsItMay) {
    engines_.wait_for = 2;
    const auto endings = sweep({one("a", 10), one("b", 11), one("c", 12), one("d", 13), one("e", 14)}, 2);
    EXPECT_EQ(exit_code(endings), 0);
    EXPECT_EQ(engines_.most, 2);
    engines_.wait_for = 3;
    sweep({one("f", 10), one("g", 11), one("h", 12)}, 7);
    EXPECT_EQ(engines_.most, 3);
}

TEST_F(Sweep, GivesTheFilesOfSingleRuns) {
    const std::vector<SweepCase> cases = {one("a", 20), one("b", 25), one("c", 30)};
    engines_.wait_for = 3;
    sweep(cases, 3);
    engines_.wait_for = 1;
    for (const SweepCase& each : cases) {
        RunOptions options;
        options.folder = folder_ / ("single-" + each.name);
        options.quiet = true;
        EXPECT_EQ(run_scene(each.scene, options, engines_.factory()), 0);
        for (const char* name : {"fill.vtkhdf", "heap.vtkhdf", "spread.vtkhdf", "trajectory.vtkhdf", "energy.csv"}) {
            EXPECT_FALSE(bytes(each.folder / name).empty());
            EXPECT_EQ(bytes(each.folder / name), bytes(options.folder / name)) << each.name << " " << name;
        }
    }
}

TEST_F(Sweep, AFailingCaseDoesNotStopTheOthers) {
    engines_.fault_of = 20;
    std::ofstream(folder_ / "b") << "a file where the folder should be";
    ::testing::internal::CaptureStderr();
    const auto endings = sweep({one("a", 20), one("b", 21), one("c", 22)}, 2);
    const std::string told = ::testing::internal::GetCapturedStderr();
    EXPECT_EQ(endings[0].code, 3);
    EXPECT_THAT(endings[0].what, StartsWith("error: particle 3 left the domain"));
    EXPECT_TRUE(fs::exists(folder_ / "a/fault.vtkhdf"));
    EXPECT_EQ(endings[1].code, 2);
    EXPECT_THAT(endings[1].what, HasSubstr("the folder cannot be made"));
    EXPECT_EQ(lines(endings)[2], "c: finished");
    EXPECT_EQ(exit_code(endings), 3);
    EXPECT_THAT(told, HasSubstr("a: error: particle 3"));
    EXPECT_THAT(told, HasSubstr("b: error: "));
}

TEST_F(Sweep, ABugOfOneCaseIsToldAndIsTheWorst) {
    engines_.bug_of = 21;
    engines_.fault_of = 20;
    ::testing::internal::CaptureStderr();
    const auto endings = sweep({one("a", 20), one("b", 21), one("c", 22)}, 3);
    ::testing::internal::GetCapturedStderr();
    EXPECT_THAT(lines(endings)[1], HasSubstr("b: internal error (a bug"));
    EXPECT_EQ(lines(endings)[2], "c: finished");
    EXPECT_EQ(exit_code(endings), 1);
}

TEST_F(Sweep, WhatIsFinishedIsLeftAsItIs) {
    sweep({one("a", 20)}, 1);
    const auto endings = sweep({one("a", 20), one("b", 21)}, 2);
    EXPECT_THAT(lines(endings), ElementsAre("a: already finished", "b: finished"));
    EXPECT_THAT(engines_.order, ElementsAre(20, 21));
}

TEST_F(Sweep, AnotherConfigurationIsRefusedOrOverwritten) {
    sweep({one("a", 20), one("b", 21)}, 2);
    ::testing::internal::CaptureStderr();
    const auto refused = sweep({one("a", 22), one("b", 21)}, 2);
    ::testing::internal::GetCapturedStderr();
    EXPECT_EQ(exit_code(refused), 2);
    EXPECT_THAT(refused[0].what, HasSubstr("the folder holds a run of another configuration"));
    EXPECT_THAT(lines(sweep({one("a", 22), one("b", 21)}, 2, true)), ElementsAre("a: finished", "b: already finished"));
}

TEST(SweepExitCode, IsThatOfTheWorstCase) {
    const auto code = [](const std::vector<int>& codes) {
        std::vector<CaseEnding> endings;
        for (const int each : codes) endings.push_back({"", each, ""});
        return exit_code(endings);
    };
    EXPECT_EQ(code({0, 0}), 0);
    EXPECT_EQ(code({0, 143, 0}), 143);
    EXPECT_EQ(code({143, 2, 0}), 2);
    EXPECT_EQ(code({2, 3, 2}), 3);
    EXPECT_EQ(code({1, 3, 143}), 1);
    EXPECT_EQ(code({3, 0, 1}), 1);
}

TEST(SweepReport, HasALineForEachCase) {
    EXPECT_EQ(sweep_report({{"a", 0, "finished"}, {"b", 3, "error: why"}}), "a: finished\nb: error: why\n");
}

// In a process of its own, for the signal stays.
TEST_F(Sweep, AfterASignalNothingBegins) {
    const auto child = [this] {
        listen_for_stop();
        (void)std::raise(SIGTERM);
        const auto endings = sweep({one("a", 20), one("b", 21)}, 2);
        const std::vector<std::string> expected = {"a: not begun", "b: not begun"};
        const bool good = lines(endings) == expected && engines_.order.empty() && exit_code(endings) == 128 + SIGTERM;
        std::_Exit(good ? 0 : 1);
    };
    EXPECT_EXIT(child(), ::testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace recoat
