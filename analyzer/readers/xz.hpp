#pragma once

#include <string>
#include <string_view>

namespace recoat {

/// Whether these bytes begin like an xz file.
[[nodiscard]] bool is_xz(std::string_view bytes);

/// What is in an xz file, all members one after the other; zeros may follow each. Throws PackingError.
[[nodiscard]] std::string unpack_xz(std::string_view packed);

}  // namespace recoat
