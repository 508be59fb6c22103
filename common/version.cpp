#include "common/version.hpp"

#include "commit.hpp"

namespace recoat {

std::string program_version() { return RECOAT_VERSION " (" RECOAT_COMMIT ")"; }

}  // namespace recoat
