#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "common/vec3.hpp"

namespace recoat {

/// What a file of particles says of itself, in SI units; NaN where it says nothing.
struct SourceInfo {
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    double particle_diameter = unknown;
    double density = unknown;
    double clearance = unknown;
    double y_min = unknown;
    double y_period = unknown;
    double blade_start = unknown;    ///< x of the rear bottom edge of the blade before spreading
    double spread_length = unknown;  ///< way of the blade
};

/// Particles of one instant as a reader found them, in the order of the file.
struct Source {
    std::string format;          ///< name of the reader
    std::vector<Vec3> position;  ///< [N] m
    std::vector<double> radius;  ///< [N] m
    SourceInfo info;
    std::vector<std::pair<std::string, std::string>> facts;  ///< further things the file says: name and value
};

/// Names of columns chosen by the user; an empty one stands for the usual names.
struct ColumnNames {
    std::string x, y, z, radius, diameter;
};

}  // namespace recoat
