#pragma once

#include <string>

#include "analyzer/analysis.hpp"
#include "analyzer/readers/source.hpp"

namespace recoat {

/// The main results of an analysis in a few lines for the terminal, the region among them.
[[nodiscard]] std::string text_summary(const Analysis& analysis, const AnalysisConfig& config);

/// What a file of particles holds, as text for the terminal or as one JSON object.
[[nodiscard]] std::string describe_source(const Source& source, const std::string& file, bool as_json);

}  // namespace recoat
