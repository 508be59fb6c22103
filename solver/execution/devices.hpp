#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace recoat {

/// A CUDA device of this machine.
struct Device {
    std::string name;
    std::size_t memory_bytes = 0;
    int major = 0, minor = 0;  ///< compute capability
};

/// What this program and this machine offer.
struct Devices {
    std::vector<Device> found;
    std::string problem;  ///< why there is none, as part of a sentence; empty where there is one
};

Devices cuda_devices();

/// Throws InputError, with the reason and what to do, when CUDA device `number` cannot be used.
void require_device(const Devices& devices, int number);

}  // namespace recoat
