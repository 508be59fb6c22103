#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analyzer/readers/xml_tree.hpp"

namespace recoat {

/// How the arrays of an XML VTK file are written.
struct ArrayEncoding {
    bool big_endian = false;
    bool compressed = false;      ///< with zlib
    std::size_t header_size = 4;  ///< bytes of a number in the header of a block
    bool appended_base64 = false;
    std::string_view appended;  ///< what follows the mark '_' of AppendedData
};

/// What the head of the file says. Throws InputError for a compression other than zlib.
[[nodiscard]] ArrayEncoding array_encoding(const XmlDocument& document, const std::string& file);

/// The numbers of a DataArray of `tuples` x `components`. Throws InputError with file and line when they are not there.
[[nodiscard]] std::vector<double> read_array(const XmlElement& array, std::size_t tuples, std::size_t components,
                                             const ArrayEncoding& encoding, const std::string& file);

/// The same of one component as whole numbers to the last bit; nothing where one is none.
[[nodiscard]] std::optional<std::vector<std::int64_t>> read_whole_array(const XmlElement& array, std::size_t count,
                                                                        const ArrayEncoding& encoding,
                                                                        const std::string& file);

}  // namespace recoat
