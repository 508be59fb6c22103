#pragma once

#include <string>
#include <string_view>

namespace recoat {

/// Whether these bytes begin like a bzip2 file.
[[nodiscard]] bool is_bzip2(std::string_view bytes);

/// What is in a bzip2 file, all members one after the other; zeros may follow each. Throws PackingError.
[[nodiscard]] std::string unpack_bzip2(std::string_view packed);

}  // namespace recoat
