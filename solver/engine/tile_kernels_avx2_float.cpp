#include "solver/engine/tile_kernels.hpp"
#include "solver/execution/simd_avx2.hpp"

#define RECOAT_TILE_SET Avx2

namespace recoat {

RECOAT_FOR_EACH_TILE_VARIANT(RECOAT_TILE_KERNELS_OF, float)

}  // namespace recoat
