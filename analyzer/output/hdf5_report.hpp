#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "analyzer/analysis.hpp"
#include "analyzer/uncertainty/uncertainty.hpp"
#include "common/hdf5.hpp"

namespace recoat {

/// Where an analysis comes from.
struct Provenance {
    std::string file;    ///< of the particles, as given
    std::string format;  ///< name of the reader
};

/// Writes an analysis as HDF5: /particles and /maps as arrays, one group of columns per metric, /voxel/N with the voxel
/// forms, /uncertainty with the intervals, /config with the resolved configuration as attributes. Every array carries
/// its unit and its definition as attributes. Existing files are replaced. Throws InputError when the file cannot be
/// written.
void write_hdf5_report(const std::filesystem::path& path, const Analysis& analysis, const AnalysisConfig& config,
                       const Provenance& provenance, const std::optional<Uncertainty>& uncertainty = {});

/// Begins such a file: its attributes. Throws InputError.
[[nodiscard]] hdf5::File create_hdf5_report(const std::filesystem::path& path, const Provenance& provenance);

/// Writes the groups of an analysis into a file or a group.
void write_report_groups(const hdf5::Group& group, const Analysis& analysis, const AnalysisConfig& config,
                         const std::optional<Uncertainty>& uncertainty);

}  // namespace recoat
