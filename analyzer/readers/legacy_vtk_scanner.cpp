#include "analyzer/readers/legacy_vtk_scanner.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "analyzer/readers/vtk_types.hpp"
#include "common/error.hpp"
#include "common/number.hpp"
#include "common/tables/text_cursor.hpp"

namespace recoat {
namespace {

constexpr std::string_view white_space = " \t\r\n\v\f";

/// Bits of an element in a binary file; 0: a type that cannot be passed over.
std::size_t bits_of(const std::string& type) {
    if (type == "bit") return 1;
    const auto known = vtk_type(type);
    return known ? 8 * known->size : 0;
}

}  // namespace

void LegacyVtkScanner::read_head() {
    (void)take_line();
    (void)take_line();
    const std::string encoding = keyword();
    if (encoding != "ASCII" && encoding != "BINARY") {
        fail(
            fmt::format("the third line says \"{}\" instead of ASCII or BINARY; copy the file again from where it was "
                        "made",
                        quotable(encoding)));
    }
    binary_ = encoding == "BINARY";
}

std::string LegacyVtkScanner::keyword() {
    skip_white_space();
    return std::string(take_word());
}

std::string LegacyVtkScanner::word(std::string_view what) {
    while (place_ < bytes_.size() && (bytes_[place_] == ' ' || bytes_[place_] == '\t')) ++place_;
    const std::string_view found = take_word();
    if (found.empty()) fail(fmt::format("the line ends where the {} should be; copy the file again", what));
    return std::string(found);
}

std::size_t LegacyVtkScanner::count(std::string_view what) {
    const std::string text = word(what);
    const auto value = parse_integer(text);
    // No array is longer than its file, whatever its type; bits are eight to a byte.
    if (!value || *value < 0 || static_cast<std::size_t>(*value) > 8 * bytes_.size()) {
        fail(fmt::format("\"{}\" is no {} that a file of {} bytes can have; copy it again from where it was made",
                         quotable(text), what, bytes_.size()));
    }
    return static_cast<std::size_t>(*value);
}

std::string_view LegacyVtkScanner::rest_of_line() const {
    return trimmed(bytes_.substr(place_, bytes_.find('\n', place_) - place_));
}

bool LegacyVtkScanner::follows(std::string_view wanted) const {
    const std::size_t start = std::min(bytes_.find_first_not_of(white_space, place_), bytes_.size());
    return bytes_.substr(start).starts_with(wanted);
}

std::vector<double> LegacyVtkScanner::numbers(std::size_t tuples, std::size_t components, const std::string& type) {
    const auto known = vtk_type(lower_case(type));
    if (!known) fail(fmt::format("\"{}\" is no type of number; write float or double", quotable(type)));
    if (binary_) return numbers_from(take_bytes(tuples, components, 8 * known->size), *known, true);
    std::vector<double> values(elements(tuples, components));
    for (double& value : values) value = take_number();
    return values;
}

std::optional<std::vector<std::int64_t>> LegacyVtkScanner::whole_numbers(std::size_t count, const std::string& type) {
    const auto known = vtk_type(lower_case(type));
    if (!known) return {};
    if (binary_) return whole_numbers_from(take_bytes(count, 1, 8 * known->size), *known, true);
    std::vector<std::int64_t> values(elements(count, 1));
    for (std::int64_t& value : values) {
        skip_white_space();
        const std::string_view text = take_word();
        const auto real = parse_number(text);
        auto whole = parse_integer(text);
        if (!whole && real) whole = whole_number(*real);
        if (!whole) return {};
        value = *whole;
    }
    return values;
}

void LegacyVtkScanner::skip_tuples(std::size_t tuples, std::size_t components, const std::string& type) {
    const std::size_t bits = bits_of(lower_case(type));
    if (binary_ && bits == 0) {
        fail(
            fmt::format("the file has an array of the type {}, which cannot be passed over; write it without, or as "
                        "ASCII",
                        quotable(type)));
    }
    if (binary_) {
        (void)take_bytes(tuples, components, bits);
        return;
    }
    for (std::size_t i = 0; i < elements(tuples, components); ++i) {
        skip_white_space();
        if (take_word().empty()) fail("the file ends within an array; copy it again from where it was made");
    }
}

void LegacyVtkScanner::skip_metadata() {
    (void)take_line();
    while (place_ < bytes_.size() && !trimmed(take_line()).empty()) {
    }
}

void LegacyVtkScanner::need_line_end() const {
    if (binary_ || trimmed(bytes_.substr(bytes_.rfind('\n') + 1)).empty()) return;
    fail("the file ends inside this line, so its last value may be cut; copy the file again from where it was made");
}

void LegacyVtkScanner::fail(const std::string& problem) const {
    if (binary_) throw InputError(fmt::format("{}: byte {}: {}", name_, place_, problem));
    const auto line = 1 + std::count(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(place_), '\n');
    throw InputError(fmt::format("{}:{}: {}", name_, line, problem));
}

std::size_t LegacyVtkScanner::elements(std::size_t tuples, std::size_t components) const {
    // The smallest element is a bit.
    const std::size_t most = 8 * bytes_.size();
    if (components == 0 || tuples <= most / components) return tuples * components;
    fail(fmt::format("{} x {} numbers are more than a file of {} bytes can have; copy it again from where it was made",
                     tuples, components, bytes_.size()));
}

void LegacyVtkScanner::skip_white_space() {
    place_ = std::min(bytes_.find_first_not_of(white_space, place_), bytes_.size());
}

std::string_view LegacyVtkScanner::take_line() {
    const std::size_t end = std::min(bytes_.find('\n', place_), bytes_.size());
    const std::string_view line = bytes_.substr(place_, end - place_);
    place_ = std::min(end + 1, bytes_.size());
    return line;
}

std::string_view LegacyVtkScanner::take_word() {
    const std::size_t end = std::min(bytes_.find_first_of(white_space, place_), bytes_.size());
    const std::string_view found = bytes_.substr(place_, end - place_);
    place_ = end;
    return found;
}

std::string_view LegacyVtkScanner::take_bytes(std::size_t tuples, std::size_t components, std::size_t bits) {
    (void)take_line();  // what is left of the line that announces the array
    const std::size_t size = (elements(tuples, components) * bits + 7) / 8;
    if (size > bytes_.size() - place_) {
        fail(fmt::format("the file ends within an array of {} bytes; copy it again from where it was made", size));
    }
    const std::string_view found = bytes_.substr(place_, size);
    place_ += size;
    return found;
}

double LegacyVtkScanner::take_number() {
    skip_white_space();
    const std::size_t start = place_;
    const std::string_view text = take_word();
    if (text.empty()) fail("the file ends within an array; copy it again from where it was made");
    const auto value = parse_number(text);
    if (value) return *value;
    place_ = start;
    const std::size_t line_start = bytes_.rfind('\n', start) + 1;
    fail(fmt::format("character {}: \"{}\" is no number; correct it or copy the file again", start - line_start + 1,
                     quotable(text)));
}

}  // namespace recoat
