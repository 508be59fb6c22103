#include "analyzer/readers/vtk_types.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace recoat {
namespace {

struct NamedType {
    std::string_view name;
    NumberType type;
};
using enum NumberType::Kind;
constexpr std::array<NamedType, 26> types = {{
    {"float", {real, 4}},
    {"double", {real, 8}},
    {"char", {whole, 1}},
    {"signed_char", {whole, 1}},
    {"unsigned_char", {natural, 1}},
    {"short", {whole, 2}},
    {"unsigned_short", {natural, 2}},
    {"int", {whole, 4}},
    {"unsigned_int", {natural, 4}},
    {"long", {whole, 8}},
    {"unsigned_long", {natural, 8}},
    {"vtkidtype", {whole, 4}},
    {"vtktypeint64", {whole, 8}},
    {"vtktypeuint64", {natural, 8}},
    {"long_long", {whole, 8}},
    {"unsigned_long_long", {natural, 8}},
    {"Float32", {real, 4}},
    {"Float64", {real, 8}},
    {"Int8", {whole, 1}},
    {"UInt8", {natural, 1}},
    {"Int16", {whole, 2}},
    {"UInt16", {natural, 2}},
    {"Int32", {whole, 4}},
    {"UInt32", {natural, 4}},
    {"Int64", {whole, 8}},
    {"UInt64", {natural, 8}},
}};

std::int64_t with_sign(std::uint64_t bits, NumberType type) {
    const auto shift = 64 - 8 * type.size;  // brings the sign to the top and back
    return static_cast<std::int64_t>(bits << shift) >> shift;
}

double number_from(std::uint64_t bits, NumberType type) {
    if (type.kind == natural) return static_cast<double>(bits);
    if (type.kind == real) {
        if (type.size == 4) return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
        return std::bit_cast<double>(bits);
    }
    return static_cast<double>(with_sign(bits, type));
}

std::optional<std::int64_t> whole_number_from(std::uint64_t bits, NumberType type) {
    if (type.kind == real) return whole_number(number_from(bits, type));
    if (type.kind == whole) return with_sign(bits, type);
    if (bits > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) return {};
    return static_cast<std::int64_t>(bits);
}

template <class Real>
std::vector<double> native_reals(std::string_view bytes) {
    std::vector<double> values(bytes.size() / sizeof(Real));
    for (std::size_t i = 0; i < values.size(); ++i) {
        Real value;
        std::memcpy(&value, bytes.data() + i * sizeof(Real), sizeof(Real));
        values[i] = value;
    }
    return values;
}

}  // namespace

std::optional<NumberType> vtk_type(std::string_view name) {
    const auto found = std::ranges::find(types, name, &NamedType::name);
    if (found == types.end()) return {};
    return found->type;
}

std::optional<std::int64_t> whole_number(double value) {
    constexpr double largest = 0x1p53;
    if (value != std::floor(value) || std::abs(value) > largest) return {};
    return static_cast<std::int64_t>(value);
}

std::optional<std::vector<std::int64_t>> whole_numbers_from(std::string_view bytes, NumberType type, bool big_endian) {
    std::vector<std::int64_t> values(bytes.size() / type.size);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto value = whole_number_from(natural_from(bytes.substr(i * type.size, type.size), big_endian), type);
        if (!value) return {};
        values[i] = *value;
    }
    return values;
}

std::uint64_t natural_from(std::string_view bytes, bool big_endian) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        const std::size_t place = big_endian ? i : bytes.size() - 1 - i;
        value = (value << 8) | static_cast<unsigned char>(bytes[place]);
    }
    return value;
}

std::vector<double> numbers_from(std::string_view bytes, NumberType type, bool big_endian) {
    // What most files have, without a loop over the bytes of each number.
    if (type.kind == real && big_endian == (std::endian::native == std::endian::big)) {
        return type.size == 8 ? native_reals<double>(bytes) : native_reals<float>(bytes);
    }
    std::vector<double> values(bytes.size() / type.size);
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = number_from(natural_from(bytes.substr(i * type.size, type.size), big_endian), type);
    }
    return values;
}

}  // namespace recoat
