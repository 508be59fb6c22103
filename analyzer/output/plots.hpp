#pragma once

#include <filesystem>
#include <string>

#include "analyzer/readers/source.hpp"

namespace recoat {

/// Draws the standard figures of one layer with the workflow's own scripts: PDF and PNG files in a folder. `report` is
/// the JSON report with intervals, `source` the particles it was made from, z from the base. The scripts are those of
/// the environment variable RECOAT_SCRIPTS, or of the source tree the program was built from; Python that of
/// RECOAT_PYTHON, the one beside that tree, or python3.
/// @throws InputError when there is no such Python, a package is missing or a script fails.
void draw_plots(const std::filesystem::path& folder, const std::string& report, const Source& source);

}  // namespace recoat
