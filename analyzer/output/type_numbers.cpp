#include "analyzer/output/type_numbers.hpp"

#include "common/number.hpp"

namespace recoat {

std::optional<std::vector<std::int64_t>> type_numbers(const Source& source) {
    std::vector<std::int64_t> numbers;
    for (const std::string& name : source.type.names) {
        const auto number = parse_integer(name);
        if (!number) return {};
        numbers.push_back(*number);
    }
    return numbers;
}

}  // namespace recoat
