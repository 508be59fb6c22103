#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace recoat {

/// A type of number in a binary array.
struct NumberType {
    enum class Kind { real, whole, natural };
    Kind kind = Kind::real;
    std::size_t size = 8;  ///< bytes
};

/// The type that legacy VTK ("float", "vtktypeint64") or XML VTK ("Float32", "Int64") calls so; nothing if unknown.
[[nodiscard]] std::optional<NumberType> vtk_type(std::string_view name);

/// Numbers from bytes, of which there are a whole number of elements.
[[nodiscard]] std::vector<double> numbers_from(std::string_view bytes, NumberType type, bool big_endian);

/// The same as whole numbers to the last bit; nothing where one is none, or has more than 64 bits with its sign.
[[nodiscard]] std::optional<std::vector<std::int64_t>> whole_numbers_from(std::string_view bytes, NumberType type,
                                                                          bool big_endian);

/// The whole number that a real one is; nothing where it is none, or too large to be known exactly.
[[nodiscard]] std::optional<std::int64_t> whole_number(double value);

/// A natural number from its bytes.
[[nodiscard]] std::uint64_t natural_from(std::string_view bytes, bool big_endian);

}  // namespace recoat
