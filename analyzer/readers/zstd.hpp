#pragma once

#include <string>
#include <string_view>

namespace recoat {

/// Whether these bytes begin like a zstd file, maybe behind frames to be passed over.
[[nodiscard]] bool is_zstd(std::string_view bytes);

/// What is in a zstd file, all members one after the other; zeros may follow each. Throws PackingError.
[[nodiscard]] std::string unpack_zstd(std::string_view packed);

}  // namespace recoat
