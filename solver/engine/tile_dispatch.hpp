#pragma once

#include "solver/engine/tile_work.hpp"
#include "solver/execution/instruction_set.hpp"

namespace recoat {

/// The loops of a variant for the instruction set that was chosen when the program started.
template <class Variant>
TileKernels<Variant> kernels_of(InstructionSet set) {
#if defined(__x86_64__)
    if (set == InstructionSet::avx512) return tile_kernels<Avx512, Variant>();
    if (set == InstructionSet::avx2) return tile_kernels<Avx2, Variant>();
#endif
    return tile_kernels<Baseline, Variant>();
}

}  // namespace recoat
