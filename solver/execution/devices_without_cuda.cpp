#include "solver/execution/devices.hpp"

namespace recoat {

namespace {

constexpr const char* problem = "this program was built without CUDA (-DRECOAT_CUDA=ON builds it in)";

}  // namespace

Devices cuda_devices() { return {{}, problem, false}; }

std::string try_device(int) { return problem; }

}  // namespace recoat
