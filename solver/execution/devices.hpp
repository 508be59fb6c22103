#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace recoat {

/// A CUDA device of this machine.
struct Device {
    std::string name;
    std::size_t memory_bytes = 0;
    int major = 0, minor = 0;  ///< compute capability
    std::string problem;       ///< why nothing is known of it, as part of a sentence; else empty
};

/// What this program and this machine offer.
struct Devices {
    std::vector<Device> found;  ///< by their numbers
    std::string problem;        ///< why there is none, as part of a sentence; empty where there is one
    bool out_of_reach = false;  ///< there seem to be some, but the driver is not fit for this program
};

Devices cuda_devices();

/// Takes device `number` into use and runs an empty kernel there. Returns why that cannot be done, as a clause without
/// a full stop, or nothing.
std::string try_device(int number);
using DeviceTrial = std::function<std::string(int)>;

/// Throws InputError, with the reason and what to do, when CUDA device `number` cannot be used.
void require_device(const Devices& devices, int number);

}  // namespace recoat
