// clang-format off: the types of the set come first
#include "solver/execution/simd_avx512.hpp"
#include "solver/engine/tile_kernels.hpp"

#define RECOAT_TILE_SET Avx512

namespace recoat {

RECOAT_FOR_EACH_TILE_VARIANT(RECOAT_TILE_KERNELS_OF, double)

}  // namespace recoat
