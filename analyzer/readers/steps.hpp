#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "analyzer/readers/series.hpp"

namespace recoat {

/// Index of the chosen time step in a series. A number that is there twice stands for its last. Throws InputError when
/// there is none of this number, or when the last is asked for and the file is damaged behind those that are whole.
[[nodiscard]] std::size_t choose_step(const Series& series, StepChoice choice, const std::string& file);

/// Throws InputError when the file is damaged behind the time steps that are whole.
void require_whole(const Series& series, const std::string& file);

/// A warning when a time step is there twice, or the counter of steps or the time goes back: both happen when a run is
/// continued into a file that is there already. `taken` is the step that is read, nothing where all are.
[[nodiscard]] std::optional<std::string> disorder(const Series& series, std::optional<std::size_t> taken,
                                                  const std::string& file);

}  // namespace recoat
