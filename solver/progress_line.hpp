#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace recoat {

/// Tells on standard error how far a stage has come: a bar on a terminal, a line every ten seconds otherwise.
class ProgressLine {
public:
    /// With a `name`, of one run among several, every line begins with it and there is no bar.
    ProgressLine(bool quiet, std::size_t particles, const std::string& name = {});

    /// Begins a stage of at most `steps` steps, `done` of which are made already.
    void begin(const std::string& stage, std::int64_t done, std::int64_t steps);
    void update(std::int64_t done);
    /// A whole sentence of its own.
    void say(const std::string& sentence);

private:
    using Clock = std::chrono::steady_clock;

    [[nodiscard]] std::string text(std::int64_t done) const;

    bool quiet_, terminal_, bar_shown_ = false;
    double particles_;
    std::string start_;  ///< of every line
    std::string stage_;
    std::int64_t first_ = 0, steps_ = 0;
    Clock::time_point begun_, shown_;
};

}  // namespace recoat
