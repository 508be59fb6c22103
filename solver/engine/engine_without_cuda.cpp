#include <stdexcept>

#include "solver/engine/build_engine.hpp"
#include "solver/execution/devices.hpp"

namespace recoat {

std::unique_ptr<Engine> build_cuda_engine(const EngineSetup& setup, Snapshot) {
    require_device(cuda_devices(), setup.resources.device);
    throw std::logic_error("a program without CUDA found a device");
}

}  // namespace recoat
