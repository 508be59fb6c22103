#include "solver/execution/devices.hpp"

namespace recoat {

Devices cuda_devices() { return {{}, "this program was built without CUDA (-DRECOAT_CUDA=ON builds it in)"}; }

}  // namespace recoat
