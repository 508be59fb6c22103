#include "solver/progress_line.hpp"

#include <cstdio>
#include <sstream>
#include <vector>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "common/readable.hpp"

namespace recoat {
namespace {

double seconds_between(std::chrono::steady_clock::time_point a, std::chrono::steady_clock::time_point b) {
    return std::chrono::duration<double>(b - a).count();
}

/// Width of the terminal behind standard error; 80 where it does not say.
int terminal_columns() {
    winsize size{};
    const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return known ? size.ws_col : 80;
}

std::string bar(double share, int width) {
    const int filled = static_cast<int>(share * width);
    return fmt::format(" [{:#<{}}{:.<{}}]", "", filled, "", width - filled);
}

/// Of the whole run, at most; empty where nothing is known yet.
std::string time_left(const Progress& progress, double rate) {
    if (!(rate > 0)) return {};
    return readable_duration(static_cast<double>(progress.steps - progress.done + progress.later) / rate);
}

/// For a file: in full.
std::string progress_log(const Progress& progress, double rate, double particles) {
    const std::string left = time_left(progress, rate);
    return fmt::format("{}: step {} of at most {}, {:.2g} particle-steps/s, {}", progress.stage, progress.done,
                       progress.steps, rate * particles,
                       left.empty() ? "time left unknown" : "at most " + left + " left of the run");
}

}  // namespace

std::string progress_text(const Progress& progress, double rate, double particles, int columns) {
    const double share =
        progress.steps > 0 ? static_cast<double>(progress.done) / static_cast<double>(progress.steps) : 1;
    const std::string percent = fmt::format("{:3.0f} %", 100 * share);
    const std::string left = time_left(progress, rate);
    const std::string run = left.empty() ? "run: time left unknown" : "run: at most " + left + " left";
    const std::string short_run = left.empty() ? "" : "< " + left;
    const std::string speed = fmt::format("{:.2g} particle-steps/s", rate * particles);
    const std::string& stage = progress.stage;
    // From the most to the least that is worth saying.
    const std::vector<std::string> forms = {
        fmt::format("{}{} {}, {}, {}", stage, bar(share, 20), percent, speed, run),
        fmt::format("{}{} {}, {}", stage, bar(share, 20), percent, run),
        fmt::format("{}{} {}, {}", stage, bar(share, 10), percent, run),
        fmt::format("{} {}, {}", stage, percent, run),
        fmt::format("{} {} {}", stage, percent, short_run),
        fmt::format("{} {}", stage, percent),
        percent,
    };
    for (const std::string& form : forms) {
        if (static_cast<int>(form.size()) <= columns) return form;
    }
    return {};
}

ProgressLine::ProgressLine(bool quiet, std::size_t particles, const std::string& name)
    : quiet_(quiet),
      terminal_(name.empty() && isatty(STDERR_FILENO) == 1),
      particles_(static_cast<double>(particles)),
      start_(name.empty() ? "" : name + ": ") {}

void ProgressLine::begin(const Progress& progress) {
    progress_ = progress;
    first_ = progress.done;
    begun_ = shown_ = Clock::now();
}

std::string ProgressLine::text() const {
    const double elapsed = seconds_between(begun_, Clock::now());
    const double rate = elapsed > 0 ? static_cast<double>(progress_.done - first_) / elapsed : 0;
    // The last column stays free: some terminals go to the next line when it is written to.
    if (terminal_) return progress_text(progress_, rate, particles_, terminal_columns() - 1);
    return start_ + progress_log(progress_, rate, particles_);
}

void ProgressLine::update(std::int64_t done) {
    if (quiet_) return;
    progress_.done = done;
    const Clock::time_point now = Clock::now();
    if (seconds_between(shown_, now) < (terminal_ ? 0.2 : 10)) return;
    shown_ = now;
    line_shown_ = terminal_;
    std::fputs((terminal_ ? "\r\033[K" + text() : text() + "\n").c_str(), stderr);
    std::fflush(stderr);
}

void ProgressLine::say(const std::string& sentence) {
    if (quiet_) return;
    std::string text = line_shown_ ? "\r\033[K" : "";
    std::istringstream lines(sentence);
    for (std::string line; std::getline(lines, line);) text += start_ + line + "\n";
    std::fputs(text.c_str(), stderr);
    line_shown_ = false;
}

}  // namespace recoat
