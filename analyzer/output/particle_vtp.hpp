#pragma once

#include <filesystem>

#include "analyzer/analysis.hpp"
#include "analyzer/readers/source.hpp"

namespace recoat {

/// Writes particles as vertices of a VTP file with the arrays Radius and, where they have them, Id, Velocity and
/// AngularVelocity.
void write_vtp(const std::filesystem::path& place, const Source& source);

/// Writes the particles of an analysed layer, y wrapped into one period, with the arrays of write_vtp() and
/// CoordinationNumber, Cluster, ClusterSize, ClusterAngle [deg, NaN: none] and InRegion. `source` is what the layer was
/// made from.
void write_layer_vtp(const std::filesystem::path& place, const Analysis& analysis, const AnalysisConfig& config,
                     const Source& source);

}  // namespace recoat
