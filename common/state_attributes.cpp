#include "common/state_attributes.hpp"

#include <type_traits>

namespace recoat {

void write_info(const hdf5::Group& group, const StateInfo& info) {
    for_each_attribute(info, [&](const char* name, const auto& value) { group.set_attribute(name, value); });
    group.set_attribute("layer_end", info.layer_end);
}

StateInfo read_info(const hdf5::Group& group) {
    StateInfo info;
    for_each_attribute(info, [&](const char* name, auto& value) {
        using Value = std::remove_reference_t<decltype(value)>;
        if constexpr (std::is_same_v<Value, double>) {
            value = group.real_attribute(name);
        } else if constexpr (std::is_same_v<Value, std::int64_t>) {
            value = group.integer_attribute(name);
        } else {
            value = group.text_attribute(name);
        }
    });
    // Older files do not have it.
    if (group.has_attribute("layer_end")) info.layer_end = group.real_attribute("layer_end");
    return info;
}

}  // namespace recoat
