#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "analyzer/readers/source.hpp"

namespace recoat {

/// Index of the chosen time step among the numbers of those in the file, of which there is at least one. A number that
/// is there twice stands for its last. Throws InputError when the file has none of this number.
[[nodiscard]] std::size_t choose_step(std::span<const std::int64_t> steps, StepChoice choice, const std::string& file);

}  // namespace recoat
