#pragma once

#include <string>
#include <string_view>

namespace recoat {

/// The bytes behind a UTF-8 byte order mark, or all of them where there is none.
[[nodiscard]] std::string_view without_byte_order_mark(std::string_view bytes);

/// "UTF-16" or "UTF-32" where the bytes begin like a text in that encoding, with a byte order mark or without; else
/// empty.
[[nodiscard]] std::string_view wide_encoding(std::string_view bytes);

/// What is wrong with a text that is in such an encoding, and what to do; empty for others.
[[nodiscard]] std::string wide_text_problem(std::string_view bytes);

/// The text in UTF-8: bytes that are not UTF-8 are taken for Latin-1 (ISO 8859-1).
[[nodiscard]] std::string in_utf8(std::string_view text);

}  // namespace recoat
