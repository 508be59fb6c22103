#include "analyzer/readers/steps.hpp"

#include <fmt/format.h>

#include "common/error.hpp"

namespace recoat {

std::size_t choose_step(std::span<const std::int64_t> steps, StepChoice choice, const std::string& file) {
    if (choice.which == StepChoice::Which::first) return 0;
    if (choice.which == StepChoice::Which::last) return steps.size() - 1;
    for (std::size_t i = steps.size(); i > 0; --i) {
        if (steps[i - 1] == choice.number) return i - 1;
    }
    throw InputError(fmt::format("{}: there is no time step {}; the file has {}, from {} to {}", file, choice.number,
                                 steps.size(), steps.front(), steps.back()));
}

}  // namespace recoat
