#pragma once

#include <memory>

#include "solver/engine/snapshot.hpp"

namespace recoat {

/// Engines of each space, from their own translation units. The second throws InputError where this program, or this
/// machine, has no CUDA.
std::unique_ptr<Engine> build_openmp_engine(const EngineSetup& setup, Snapshot snapshot);
std::unique_ptr<Engine> build_cuda_engine(const EngineSetup& setup, Snapshot snapshot);

}  // namespace recoat
