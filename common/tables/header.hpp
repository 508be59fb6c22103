#pragma once

#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "common/tables/columns.hpp"
#include "common/units.hpp"

namespace recoat {

/// The columns of a table are not what particles need; the message says what is wrong, without a place.
struct ColumnError : std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

/// A unit of what particles have in columns: a length, a speed or an angular velocity.
struct ColumnUnit {
    Dimension dimension = Dimension::length;
    double factor = 1;  ///< to the SI unit
};

/// The unit with this symbol, in UTF-8 or Latin-1, or nothing.
[[nodiscard]] std::optional<ColumnUnit> column_unit(std::string_view symbol);

/// Names of the columns of a table and the units that they carry: "x [um]", "Radius (m)".
class Header {
public:
    /// From the names as they stand, in UTF-8 or Latin-1.
    explicit Header(std::span<const std::string> names);

    [[nodiscard]] std::size_t size() const { return names_.size(); }
    /// As they stand, in small letters.
    [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
    /// Without their units; usual names are found among these.
    [[nodiscard]] const std::vector<std::string>& bare_names() const { return bare_names_; }

    /// The column that the user chose, by its name as it stands or without its unit. Throws ColumnError when there is
    /// none.
    [[nodiscard]] std::size_t choose(std::string_view name);
    /// The unit of a column whose name has none, from a row of units.
    void set_unit(std::size_t column, std::string_view symbol);
    [[nodiscard]] bool has_unit(std::size_t column) const { return !symbols_[column].empty(); }

    /// What to multiply the values of a column with to get SI units; 1 where it names no unit. Throws ColumnError when
    /// its unit is not of this dimension, or another column has the same name.
    [[nodiscard]] double factor(std::size_t column, Dimension dimension) const;

private:
    std::vector<std::string> names_, bare_names_, symbols_;
};

/// The column of the size: the one that the user chose, or one with a usual name. Throws ColumnError when the chosen
/// one is not there.
[[nodiscard]] std::optional<SizeColumn> choose_size(Header& header, const ColumnNames& chosen);

/// Where a table has what.
struct ParticleColumns {
    VectorColumns position = {};
    std::optional<SizeColumn> size;
    std::optional<std::size_t> id, type;
    std::optional<VectorColumns> velocity, angular_velocity;
};

/// The columns that the user chose, or those with usual names. Throws ColumnError when a coordinate is not there.
[[nodiscard]] ParticleColumns find_particle_columns(Header& header, const ColumnNames& chosen);

/// Whether these columns, all lengths, have units: all, or none. Throws ColumnError when some have.
[[nodiscard]] bool lengths_have_units(const Header& header, std::span<const std::size_t> lengths);

}  // namespace recoat
