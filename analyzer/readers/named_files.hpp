#pragma once

#include <string>
#include <vector>

#include "analyzer/readers/content.hpp"
#include "analyzer/readers/series.hpp"

namespace recoat {

/// A file that another one names.
struct NamedFile {
    std::string name;   ///< as it stands there: relative to the folder of the other, or absolute
    std::string place;  ///< where it is named, for errors: "file:line"
};

/// The files of one time step: their particles are one set.
struct NamedStep {
    std::vector<NamedFile> files;
    double time = 0;
};

/// The particles of several files together, lengths in the unit of the files. Throws InputError when one cannot be
/// read, holds more than one time step, is not `allowed` or says other things of its particles than the rest.
[[nodiscard]] Source read_named_files(const Content& content, const NamedStep& step, const ReadOptions& options,
                                      bool (*allowed)(const Content& named));

/// A series of such steps, whose numbers count from 0.
[[nodiscard]] Series named_series(const Content& content, std::vector<NamedStep> steps, const ReadOptions& options,
                                  bool (*allowed)(const Content& named));

}  // namespace recoat
