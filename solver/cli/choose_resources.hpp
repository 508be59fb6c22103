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

/// `auto` takes the CUDA device where one can be used. Throws InputError when the backend asked for is not there.
Resources choose_resources(const ResourceRequest& request, const Devices& devices);

}  // namespace recoat
