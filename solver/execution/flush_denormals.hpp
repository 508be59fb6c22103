#pragma once

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace recoat {

/// While it lives, this thread takes numbers below the smallest normal one for 0. Velocities of particles at rest decay
/// to such numbers, and each operation on one costs a processor more than a hundred cycles.
class FlushDenormals {
public:
#if defined(__SSE2__)
    FlushDenormals() : before_(_mm_getcsr()) { _mm_setcsr(before_ | flush_results | flush_operands); }
    ~FlushDenormals() { _mm_setcsr(before_); }
#else
    FlushDenormals() = default;
    ~FlushDenormals() = default;
#endif
    FlushDenormals(const FlushDenormals&) = delete;
    FlushDenormals& operator=(const FlushDenormals&) = delete;

private:
#if defined(__SSE2__)
    static constexpr unsigned flush_results = 0x8000, flush_operands = 0x0040;
    unsigned before_;
#endif
};

}  // namespace recoat
