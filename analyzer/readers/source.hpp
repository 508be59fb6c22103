#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/tables/columns.hpp"
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
    double base = unknown;           ///< z of the base
    double x_lower = unknown;        ///< smallest and largest x of the centres
    double x_upper = unknown;
    double y_lower = unknown;  ///< bounds along y, periodic or not
    double y_upper = unknown;
};

/// The box of a simulation, in the unit of the positions.
struct Box {
    Vec3 lower, upper;
    std::array<bool, 3> periodic = {};   ///< along x, y, z; false where the file says nothing
    std::array<bool, 3> unwrapped = {};  ///< positions may lie in another image of the box
    bool closed = true;                  ///< whether no particle lies beyond it where it is not periodic
};

/// Kinds of particles, under the names that the file gives them: numbers or words.
struct ParticleTypes {
    std::vector<std::string> names;  ///< every name once, in the order in which they turn up
    std::vector<std::uint32_t> of;   ///< [N] places in `names`; empty where the file gives no types

    /// Adds a particle of the type of this name.
    void add(std::string_view name);
};

/// Particles of one instant as a reader found them, in the order of the file.
struct Source {
    std::string format;                  ///< name of the reader
    std::vector<Vec3> position;          ///< [N] m
    std::vector<double> radius;          ///< [N] m; a reader leaves it empty where the file has none
    std::vector<Vec3> velocity;          ///< [N] m/s, or empty
    std::vector<Vec3> angular_velocity;  ///< [N] rad/s, or empty
    std::vector<std::int64_t> id;        ///< [N] identities, or empty
    ParticleTypes type;                  ///< of the particles, or without any
    std::vector<std::size_t> line;       ///< [N] lines of a text file, or empty
    std::optional<Box> box;              ///< where the file has one
    std::optional<double> own_unit;      ///< unit of length [m] where the file has one
    double time_unit = 1;                ///< of the velocities as a reader leaves them [s]
    std::int64_t step = 0;               ///< number of the time step, 0 where the file has none
    double time = SourceInfo::unknown;   ///< [s]; NaN where the file has none
    SourceInfo info;
    std::vector<std::pair<std::string, std::string>> facts;  ///< further things the file says: name and value
    std::vector<std::string> columns;   ///< names of all columns or arrays, where the file names them
    std::vector<std::string> warnings;  ///< whole sentences: what the user should know although the file was read
};

/// Which of several instants in a file is read.
struct StepChoice {
    enum class Which { last, first, number };
    Which which = Which::last;
    std::int64_t number = 0;  ///< number of the time step as the file has it
};

/// What the user says about a file that does not say it itself.
struct ReadOptions {
    ColumnNames columns = {};
    std::optional<double> length_unit = {};             ///< [m]
    std::optional<double> radius = {};                  ///< of all particles [m]
    std::map<std::string, double> radius_of_type = {};  ///< [m], by the name of the type
    std::vector<std::string> types = {};                ///< the only ones that are kept; empty: all
    std::vector<std::string> types_left_out = {};
    std::string atom_style = {};       ///< of a LAMMPS data file that does not say it
    bool leave_out_size_zero = false;  ///< particles of size 0, which some programs write as placeholders
    StepChoice step = {};

    /// Whether particles of size 0 may be read, for they may be left out later.
    [[nodiscard]] bool allow_size_zero() const {
        return leave_out_size_zero || !types.empty() || !types_left_out.empty();
    }
};

}  // namespace recoat
