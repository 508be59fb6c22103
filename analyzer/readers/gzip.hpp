#pragma once

#include <string>
#include <string_view>

namespace recoat {

/// Whether these bytes begin like a gzip file.
[[nodiscard]] bool is_gzip(std::string_view bytes);

/// What is in a gzip file, all members one after the other; zeros may follow each. Throws PackingError.
[[nodiscard]] std::string unpack_gzip(std::string_view packed);

}  // namespace recoat
