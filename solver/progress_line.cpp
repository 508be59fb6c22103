#include "solver/progress_line.hpp"

#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

namespace recoat {
namespace {

std::string duration_text(double seconds) {
    if (seconds < 100) return fmt::format("{:.0f} s", seconds);
    if (seconds < 6000) return fmt::format("{:.0f} min", seconds / 60);
    return fmt::format("{:.1f} h", seconds / 3600);
}

double seconds_between(std::chrono::steady_clock::time_point a, std::chrono::steady_clock::time_point b) {
    return std::chrono::duration<double>(b - a).count();
}

}  // namespace

ProgressLine::ProgressLine(bool quiet, std::size_t particles, const std::string& name)
    : quiet_(quiet),
      terminal_(name.empty() && isatty(STDERR_FILENO) == 1),
      particles_(static_cast<double>(particles)),
      start_(name.empty() ? "" : name + ": ") {}

void ProgressLine::begin(const std::string& stage, std::int64_t done, std::int64_t steps) {
    stage_ = stage;
    first_ = done;
    steps_ = steps;
    begun_ = shown_ = Clock::now();
}

std::string ProgressLine::text(std::int64_t done) const {
    const double elapsed = seconds_between(begun_, Clock::now());
    const double rate = elapsed > 0 ? static_cast<double>(done - first_) / elapsed : 0;
    const double share = steps_ > 0 ? static_cast<double>(done) / static_cast<double>(steps_) : 1;
    const std::string left = rate > 0 ? duration_text(static_cast<double>(steps_ - done) / rate) : "unknown time";
    const std::string rates = fmt::format("{:.2e} particle-steps/s, at most {} left", rate * particles_, left);
    if (!terminal_) return fmt::format("{}{}: step {} of at most {}, {}", start_, stage_, done, steps_, rates);
    const int filled = static_cast<int>(share * 20);
    return fmt::format("{} [{:#<{}}{:.<{}}] {:3.0f} %, {}", stage_, "", filled, "", 20 - filled, 100 * share, rates);
}

void ProgressLine::update(std::int64_t done) {
    if (quiet_) return;
    const Clock::time_point now = Clock::now();
    if (seconds_between(shown_, now) < (terminal_ ? 0.2 : 10)) return;
    shown_ = now;
    bar_shown_ = terminal_;
    std::fputs((terminal_ ? "\r\033[K" + text(done) : text(done) + "\n").c_str(), stderr);
    std::fflush(stderr);
}

void ProgressLine::say(const std::string& sentence) {
    if (quiet_) return;
    std::fputs(((bar_shown_ ? "\r\033[K" : "") + start_ + sentence + "\n").c_str(), stderr);
    bar_shown_ = false;
}

}  // namespace recoat
