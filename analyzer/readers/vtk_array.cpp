#include "analyzer/readers/vtk_array.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "analyzer/readers/binary_blocks.hpp"
#include "analyzer/readers/vtk_types.hpp"
#include "common/error.hpp"
#include "common/number.hpp"
#include "common/tables/text_cursor.hpp"

namespace recoat {
namespace {

[[noreturn]] void fail(const std::string& file, const XmlElement& array, const std::string& problem) {
    throw InputError(fmt::format("{}:{}: the array \"{}\" {}; copy the file again from where it was made", file,
                                 array.line, quotable(array.attribute("Name")), problem));
}

std::vector<double> read_ascii(const XmlElement& array, std::size_t count, const std::string& file) {
    std::vector<double> values;
    TextCursor cursor(file, array.text);
    while (cursor.next_filled()) {
        cursor.split();
        for (const std::string_view cell : cursor.cells()) {
            const auto value = parse_number(cell);
            if (!value) {
                throw InputError(fmt::format("{}:{}: \"{}\" is no number; correct it or copy the file again", file,
                                             array.text_line + cursor.line_number() - 1, quotable(cell)));
            }
            values.push_back(*value);
        }
    }
    if (values.size() != count) fail(file, array, fmt::format("has {} numbers instead of {}", values.size(), count));
    return values;
}

/// The bytes behind the offset of an appended array.
std::string_view appended_bytes(const XmlElement& array, const ArrayEncoding& encoding, const std::string& file) {
    const auto offset = parse_integer(array.attribute("offset"));
    if (!offset || *offset < 0 || static_cast<std::size_t>(*offset) >= encoding.appended.size()) {
        fail(file, array,
             fmt::format("has the offset \"{}\" into {} bytes of appended data", quotable(array.attribute("offset")),
                         encoding.appended.size()));
    }
    return encoding.appended.substr(static_cast<std::size_t>(*offset));
}

bool is_ascii(const XmlElement& array) { return array.attribute("format", "ascii") == "ascii"; }

std::optional<std::vector<std::int64_t>> read_whole_ascii(const XmlElement& array, const std::string& file) {
    std::vector<std::int64_t> values;
    TextCursor cursor(file, array.text);
    while (cursor.next_filled()) {
        cursor.split();
        for (const std::string_view cell : cursor.cells()) {
            const auto real = parse_number(cell);
            auto value = parse_integer(cell);
            if (!value && real) value = whole_number(*real);
            if (!value) return {};
            values.push_back(*value);
        }
    }
    return values;
}

NumberType type_of(const XmlElement& array, const std::string& file) {
    const auto type = vtk_type(array.attribute("type"));
    if (!type) fail(file, array, fmt::format("is of the type \"{}\"", quotable(array.attribute("type"))));
    return *type;
}

/// The `size` bytes of a binary array.
std::string bytes_of(const XmlElement& array, std::size_t size, const ArrayEncoding& encoding,
                     const std::string& file) {
    const std::string format = array.attribute("format");
    try {
        const bool inline_data = format == "binary";
        if (!inline_data && format != "appended")
            throw BlockError(fmt::format("has the format \"{}\"", quotable(format)));
        const std::string_view text =
            inline_data ? std::string_view(array.text) : appended_bytes(array, encoding, file);
        ByteStream stream(text, inline_data || encoding.appended_base64);
        const BlockHeader header{encoding.header_size, encoding.big_endian};
        return encoding.compressed ? read_compressed(stream, header, size) : read_plain(stream, header, size);
    } catch (const BlockError& error) {
        fail(file, array, error.what());
    }
}

}  // namespace

ArrayEncoding array_encoding(const XmlDocument& document, const std::string& file) {
    ArrayEncoding encoding;
    encoding.big_endian = document.root.attribute("byte_order") == "BigEndian";
    encoding.header_size = document.root.attribute("header_type") == "UInt64" ? 8 : 4;
    const std::string compressor = document.root.attribute("compressor");
    encoding.compressed = !compressor.empty();
    if (encoding.compressed && compressor != "vtkZLibDataCompressor") {
        throw InputError(fmt::format("{}:{}: the data are compressed by {}; write them with zlib or not compressed",
                                     file, document.root.line, quotable(compressor)));
    }
    const auto named = document.last_attributes.find("encoding");
    encoding.appended_base64 = named == document.last_attributes.end() || named->second != "raw";
    const std::size_t mark = document.rest.find_first_not_of(" \t\r\n");
    if (mark != std::string_view::npos && document.rest[mark] == '_')
        encoding.appended = document.rest.substr(mark + 1);
    return encoding;
}

std::vector<double> read_array(const XmlElement& array, std::size_t tuples, std::size_t components,
                               const ArrayEncoding& encoding, const std::string& file) {
    if (array.attribute("NumberOfComponents", "1") != std::to_string(components)) {
        fail(file, array,
             fmt::format("has {} components instead of {}", quotable(array.attribute("NumberOfComponents", "1")),
                         components));
    }
    const std::size_t count = tuples * components;
    if (is_ascii(array)) return read_ascii(array, count, file);
    const NumberType type = type_of(array, file);
    return numbers_from(bytes_of(array, count * type.size, encoding, file), type, encoding.big_endian);
}

std::optional<std::vector<std::int64_t>> read_whole_array(const XmlElement& array, std::size_t count,
                                                          const ArrayEncoding& encoding, const std::string& file) {
    if (is_ascii(array)) return read_whole_ascii(array, file);
    const NumberType type = type_of(array, file);
    return whole_numbers_from(bytes_of(array, count * type.size, encoding, file), type, encoding.big_endian);
}

}  // namespace recoat
