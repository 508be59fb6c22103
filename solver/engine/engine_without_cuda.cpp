#include "common/error.hpp"
#include "solver/engine/build_engine.hpp"

namespace recoat {

std::unique_ptr<Engine> build_cuda_engine(const EngineSetup&, Snapshot) {
    throw InputError("this program was built without CUDA; build it with -DRECOAT_CUDA=ON, or use --backend cpu");
}

}  // namespace recoat
