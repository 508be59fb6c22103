#pragma once

#include <string>
#include <string_view>

namespace recoat {

/// A way in which whole files are packed.
struct Packing {
    std::string_view name;
    bool (*begins)(std::string_view bytes);          ///< whether these bytes begin like such a file
    std::string (*unpack)(std::string_view packed);  ///< throws PackingError
};

/// The way in which these bytes are packed, or null.
[[nodiscard]] const Packing* packing_of(std::string_view bytes);

/// What is in a packed file, all members one after the other. Throws InputError naming `file` when it is damaged or
/// ends too early.
[[nodiscard]] std::string unpack(const Packing& packing, std::string_view packed, const std::string& file);

}  // namespace recoat
