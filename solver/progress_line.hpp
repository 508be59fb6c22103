#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace recoat {

/// How far a run has come.
struct Progress {
    std::string stage;
    std::int64_t done = 0;   ///< steps of the stage
    std::int64_t steps = 0;  ///< of the stage, at most
    std::int64_t later = 0;  ///< steps of all stages after it, at most
};

/// One line about `progress` in at most `columns` columns, with what matters most where there is little room. `rate`:
/// steps per second; 0 where it is not known yet.
std::string progress_text(const Progress& progress, double rate, double particles, int columns);

/// Tells on standard error how far a run has come: one line that is rewritten on a terminal, a line every ten seconds
/// otherwise.
class ProgressLine {
public:
    /// With a `name`, of one run among several, every line begins with it and none is rewritten.
    ProgressLine(bool quiet, std::size_t particles, const std::string& name = {});

    /// Begins a stage; `done` of its steps are made already.
    void begin(const Progress& progress);
    void update(std::int64_t done);
    /// A whole sentence of its own, or several lines of them.
    void say(const std::string& sentence);

private:
    using Clock = std::chrono::steady_clock;

    [[nodiscard]] std::string text() const;

    bool quiet_, terminal_, line_shown_ = false;
    double particles_;
    std::string start_;  ///< of every line
    Progress progress_;
    std::int64_t first_ = 0;  ///< steps that the stage had when it was begun
    Clock::time_point begun_, shown_;
};

}  // namespace recoat
