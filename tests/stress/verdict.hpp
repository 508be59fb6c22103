#pragma once

#include <filesystem>
#include <string>

#include "tests/stress/run_case.hpp"

namespace recoat::stress {

/// What a run came to. The first three are right; everything else is a bug.
enum class Outcome { finished, stopped, refused, crash, hang, bad_sentence, no_state, not_finite, lost, open_ledger };

std::string name_of(Outcome outcome);
inline bool is_right(Outcome outcome) { return outcome <= Outcome::refused; }

struct Verdict {
    Outcome outcome = Outcome::finished;
    std::string reason;
    double ledger_error = 0;  ///< largest over the run, over the energy exchanged [-]
    double ledger_bound = 0;  ///< that it may be [-]
    double step = 0;          ///< time step times the highest frequency of a contact [-]
};

/// Judges the run of FOLDER/scene.yaml into FOLDER/out by what it left.
Verdict judge(const Ending& ending, const std::filesystem::path& folder);

}  // namespace recoat::stress
