#include "solver/engine/build_engine.hpp"
#include "solver/engine/engine_of.hpp"

namespace recoat {

std::unique_ptr<Engine> build_openmp_engine(const EngineSetup& setup, Snapshot snapshot) {
    return build_engine<OpenMP>(setup, std::move(snapshot));
}

}  // namespace recoat
