#include "analyzer/commands/warnings.hpp"

#include "common/error.hpp"

namespace recoat {

void Warnings::show(const Source& source) {
    for (const std::string& sentence : source.warnings) {
        if (shown_.insert(sentence).second) warn("recoat-analyze", sentence);
    }
}

}  // namespace recoat
