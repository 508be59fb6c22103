#pragma once

#include <string>

namespace recoat {

/// Version and commit of the code, e.g. "0.1.0 (1a2b3c4d5e6f)"; a commit that ends in "-dirty" had local changes.
std::string program_version();

}  // namespace recoat
