#pragma once

#include <string>

#include "solver/execution/devices.hpp"
#include "solver/execution/resources.hpp"

namespace recoat {

/// What the user asked for on the command line.
struct ResourceRequest {
    std::string backend = "auto";  ///< auto, cpu or cuda
    int device = 0;
    int threads = 0;  ///< 0: all
};

struct ResourceChoice {
    Resources resources;
    std::string notice;  ///< a sentence for the user, where it is not what they may expect; else empty
};

/// `auto` takes the CUDA device where one can be used, or else says why not, unless the machine has none. Throws
/// InputError when the backend asked for is not there.
ResourceChoice choose_resources(const ResourceRequest& request, const Devices& devices, const DeviceTrial& trial);

}  // namespace recoat
