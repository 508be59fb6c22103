#pragma once

#include <set>
#include <string>

#include "analyzer/readers/source.hpp"

namespace recoat {

/// Shows the warnings of what has been read on standard error, each of them once.
class Warnings {
public:
    void show(const Source& source);

private:
    std::set<std::string> shown_;
};

}  // namespace recoat
