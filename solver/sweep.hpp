#pragma once

#include <string>
#include <vector>

#include "solver/run.hpp"
#include "solver/sweep_file.hpp"

namespace recoat {

struct SweepOptions {
    Resources resources;  ///< of each case
    int jobs = 1;         ///< cases that run at the same time, at most
    bool quiet = false;
    bool overwrite = false;  ///< as in RunOptions
};

/// How a case of a sweep ended.
struct CaseEnding {
    std::string name;
    int code = 0;      ///< exit code, as run_scene would have it
    std::string what;  ///< "finished", "already finished", ..., or the sentence of the error
};

/// Runs the cases, each in a thread and with an engine of its own, `options.jobs` at a time in the order given. A case
/// that fails does not stop the others; its sentence goes to standard error at once. After a signal those that run stop
/// with a checkpoint and the others do not begin. The endings are in the order of the cases.
std::vector<CaseEnding> run_sweep(const std::vector<SweepCase>& cases, const SweepOptions& options,
                                  const EngineFactory& factory);

/// Exit code of a sweep, that of its worst case: 1 (a bug) before 3, 2, 128 + signal, and 0.
int exit_code(const std::vector<CaseEnding>& endings);

/// One line for each case: its name and how it ended.
std::string sweep_report(const std::vector<CaseEnding>& endings);

}  // namespace recoat
