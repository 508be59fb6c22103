#include "analyzer/readers/steps.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "common/error.hpp"
#include "common/number.hpp"

namespace recoat {
namespace {

/// All numbers, or the first and the last of many.
std::string listed(const std::vector<std::int64_t>& steps) {
    constexpr std::size_t most = 12, shown_first = 8;
    if (steps.size() <= most) return fmt::format("{}", fmt::join(steps, ", "));
    return fmt::format("{}, ..., {}", fmt::join(steps.begin(), steps.begin() + shown_first, ", "), steps.back());
}

/// The first step that does not follow the one before it, 0 when all do.
std::size_t first_out_of_order(const Series& series) {
    for (std::size_t i = 1; i < series.steps.size(); ++i) {
        if (series.steps[i] <= series.steps[i - 1]) return i;
        if (i < series.times.size() && series.times[i] <= series.times[i - 1]) return i;
    }
    return 0;
}

}  // namespace

void scan_steps(Series& series, const std::function<bool()>& scan) {
    try {
        while (scan()) continue;
    } catch (const InputError& error) {
        if (series.steps.empty()) throw;
        series.damage = error.what();
    }
}

void require_whole(const Series& series, const std::string&) {
    if (series.damage.empty()) return;
    throw InputError(fmt::format("{}; what stands before it is whole: {} time step{} ({}), which --step {} reads",
                                 series.damage, series.steps.size(), series.steps.size() == 1 ? "" : "s",
                                 listed(series.steps), series.steps.back()));
}

std::size_t choose_step(const Series& series, StepChoice choice, const std::string& file) {
    if (choice.which == StepChoice::Which::first) return 0;
    if (choice.which == StepChoice::Which::last) {
        require_whole(series, file);
        return series.steps.size() - 1;
    }
    for (std::size_t i = series.steps.size(); i > 0; --i) {
        if (series.steps[i - 1] == choice.number) return i - 1;
    }
    throw InputError(fmt::format(
        "{}: there is no time step {}; the file has {}: {}{}", file, choice.number, series.steps.size(),
        listed(series.steps), series.damage.empty() ? "" : " (and damaged data behind them: " + series.damage + ")"));
}

std::optional<std::string> disorder(const Series& series, std::optional<std::size_t> taken, const std::string& file) {
    const std::size_t i = first_out_of_order(series);
    if (i == 0) return {};
    const std::int64_t number = series.steps[i], before = series.steps[i - 1];
    std::string what =
        number == before  ? fmt::format("the time step {} is there twice", number)
        : number < before ? fmt::format("the counter of time steps goes back from {} to {}", before, number)
        : series.times[i] == series.times[i - 1]
            ? fmt::format("the time {} is there twice", shortest(series.times[i]))
            : fmt::format("the time goes back from {} to {}", shortest(series.times[i - 1]), shortest(series.times[i]));
    what = fmt::format("{}: {} (places {} and {} of {} in the file)", file, what, i, i + 1, series.steps.size());
    if (!taken) return what + "; all are taken, in the order of the file";
    const std::int64_t chosen = series.steps[*taken];
    const auto same = std::ranges::count(series.steps, chosen);
    return fmt::format("{}; taken is the step {} at place {}{}", what, chosen, *taken + 1,
                       same == 1 ? "" : fmt::format(", one of {} of this number", same));
}

}  // namespace recoat
