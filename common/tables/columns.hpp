#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace recoat {

/// Names of columns chosen by the user; an empty one stands for the usual names.
struct ColumnNames {
    std::string x, y, z, radius, diameter, type;
};

/// The column that holds the size of the particles, and what to multiply it with to get the radius.
struct SizeColumn {
    std::size_t index = 0;
    double to_radius = 1;
};

/// Place of a name among the names, which are in small letters; the name's own letters do not matter.
[[nodiscard]] std::optional<std::size_t> find_column(std::span<const std::string> names, std::string_view name);

// The functions below look for the names that DEM codes use, in small letters; blanks, signs and a leading "particle"
// do not matter: "position_x", "Position X", "Particle Position X", "position[x]" are one name.

/// The first column with a usual name of this coordinate: 'x', 'y' or 'z'.
[[nodiscard]] std::optional<std::size_t> find_coordinate(std::span<const std::string> names, char axis);

/// The column of the identities of the particles.
[[nodiscard]] std::optional<std::size_t> find_id(std::span<const std::string> names);

/// The three columns of a vector.
using VectorColumns = std::array<std::size_t, 3>;

/// The columns with a usual name of the velocity: vx, velocity_x, "velocity:0" ...
[[nodiscard]] std::optional<VectorColumns> find_velocity(std::span<const std::string> names);

/// The columns with a usual name of the angular velocity: omegax, "AngularVelocity:0" ...
[[nodiscard]] std::optional<VectorColumns> find_angular_velocity(std::span<const std::string> names);

/// A column with the name of a component of a velocity or angular velocity of which another is not there.
[[nodiscard]] std::optional<std::size_t> find_part_of_velocity(std::span<const std::string> names);

/// The column of the type with a usual name.
[[nodiscard]] std::optional<std::size_t> find_usual_type(std::span<const std::string> names);

/// The column of the type: the one that the user chose, or find_usual_type(). When there is none that the user chose,
/// calls `fail` with the problem.
[[nodiscard]] std::optional<std::size_t> find_type(std::span<const std::string> names, const ColumnNames& chosen,
                                                   const std::function<void(const std::string&)>& fail);

/// The column of the size with a usual name of a radius or a diameter.
[[nodiscard]] std::optional<SizeColumn> find_usual_size(std::span<const std::string> names);

/// The column of the size: the one that the user chose, or find_usual_size(). When there is none that the user chose,
/// calls `fail` with the problem.
[[nodiscard]] std::optional<SizeColumn> find_size(std::span<const std::string> names, const ColumnNames& chosen,
                                                  const std::function<void(const std::string&)>& fail);

}  // namespace recoat
