#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analyzer/readers/source.hpp"

namespace recoat {

/// Points of a VTK file with those of their arrays that can be of use, as columns of one number per point.
struct VtkPoints {
    std::vector<Vec3> position;
    std::vector<std::string> names;           ///< of the columns, in small letters; "name:0" ... "name:2" of vectors
    std::vector<std::vector<double>> arrays;  ///< [names][N]
    std::vector<std::string> offered;         ///< names of all arrays of the points in the file
    std::vector<std::int64_t> identities;     ///< as many as points, where all of them are whole numbers

    /// Whether an array can be of use: a size, an identity, a velocity, or what the user asks for.
    [[nodiscard]] static bool wanted(std::string_view name, std::size_t components, const ColumnNames& chosen);

    /// Whether this is the array of the identities, which are appended as whole numbers too.
    [[nodiscard]] static bool holds_identities(std::string_view name, std::size_t components);
    void append_identities(const std::optional<std::vector<std::int64_t>>& values);
    /// Notes that the points have an array of this name.
    void offer(const std::string& name);

    /// Adds points, three numbers each.
    void append_positions(std::span<const double> flat);
    /// Adds the values of an array of 1 or 3 components behind those that it has.
    void append(std::string_view name, std::size_t components, std::span<const double> values);
    /// The column of an array, of a vector the first.
    [[nodiscard]] std::optional<std::size_t> find(std::string_view name, std::size_t components) const;
};

/// Particles from points: size and identity by the names of the arrays. `file` is for errors.
[[nodiscard]] Source particles_from(VtkPoints points, const ColumnNames& chosen, const std::string& file);

}  // namespace recoat
