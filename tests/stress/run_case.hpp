#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace recoat::stress {

/// How a run of the solver ended.
struct Ending {
    int code = 0;          ///< exit code; 128 + signal when one killed it
    bool hung = false;     ///< killed because the time was over
    std::string sentence;  ///< standard error
};

/// Runs FOLDER/scene.yaml into FOLDER/out in a process of its own: with `program`, or with the solver's code in this
/// program.
Ending run_case(const std::filesystem::path& folder, int threads, double seconds,
                const std::optional<std::filesystem::path>& program);

}  // namespace recoat::stress
