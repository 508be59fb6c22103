#include "solver/engine/build_engine.hpp"
#include "solver/engine/engine_of.hpp"
#include "solver/execution/cuda.cuh"
#include "solver/execution/devices.hpp"

namespace recoat {

std::unique_ptr<Engine> build_cuda_engine(const EngineSetup& setup, Snapshot snapshot) {
    require_device(cuda_devices(), setup.resources.device);
    return build_engine<Cuda>(setup, std::move(snapshot));
}

}  // namespace recoat
