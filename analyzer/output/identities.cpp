#include "analyzer/output/identities.hpp"

#include <numeric>

namespace recoat {

std::vector<std::int64_t> identities(const Source& source) {
    if (!source.id.empty()) return source.id;
    std::vector<std::int64_t> id(source.position.size());
    std::iota(id.begin(), id.end(), std::int64_t{1});
    return id;
}

}  // namespace recoat
