#include "solver/sweep.hpp"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <thread>

#include "common/error.hpp"
#include "solver/stop_request.hpp"

namespace recoat {
namespace {

RunOptions run_options(const SweepCase& one, const SweepOptions& options) {
    RunOptions result;
    result.folder = one.folder;
    result.resources = options.resources;
    result.quiet = options.quiet;
    result.overwrite = options.overwrite;
    result.name = one.name;
    return result;
}

CaseEnding run_case(const SweepCase& one, const SweepOptions& options, const EngineFactory& factory) {
    if (stop_signal() != 0) return {one.name, 128 + stop_signal(), "not begun"};
    std::string what;
    const Ending ending = ending_of([&] {
        const RunOptions run = run_options(one, options);
        if (is_finished(one.scene, run)) {
            what = "already finished";
            return 0;
        }
        const int code = run_scene(one.scene, run, factory);
        what = code == 0 ? "finished" : "stopped with a checkpoint";
        return code;
    });
    if (ending.sentence.empty()) return {one.name, ending.code, what};
    const std::string kind = ending.code == 1 ? "internal error (a bug: please report it with the input)" : "error";
    CaseEnding failed{one.name, ending.code, kind + ": " + ending.sentence};
    std::fputs((one.name + ": " + failed.what + "\n").c_str(), stderr);
    return failed;
}

/// Larger is worse.
int badness(int code) {
    switch (code) {
        case 0:
            return 0;
        case 2:
            return 2;
        case 3:
            return 3;
        case 1:
            return 4;
        default:
            return 1;  // a signal
    }
}

}  // namespace

std::vector<CaseEnding> run_sweep(const std::vector<SweepCase>& cases, const SweepOptions& options,
                                  const EngineFactory& factory) {
    std::vector<CaseEnding> endings(cases.size());
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        for (std::size_t i = next++; i < cases.size(); i = next++) endings[i] = run_case(cases[i], options, factory);
    };
    std::vector<std::jthread> workers;
    const std::size_t jobs = std::clamp<std::size_t>(static_cast<std::size_t>(options.jobs), 1, cases.size());
    for (std::size_t i = 0; i < jobs; ++i) workers.emplace_back(work);
    workers.clear();  // waits for them
    return endings;
}

int exit_code(const std::vector<CaseEnding>& endings) {
    int worst = 0;
    for (const CaseEnding& ending : endings) {
        if (badness(ending.code) > badness(worst)) worst = ending.code;
    }
    return worst;
}

std::string sweep_report(const std::vector<CaseEnding>& endings) {
    std::string text;
    for (const CaseEnding& ending : endings) text += ending.name + ": " + ending.what + "\n";
    return text;
}

}  // namespace recoat
