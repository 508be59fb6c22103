#pragma once

#include <immintrin.h>
#include <xsimd/xsimd.hpp>

#include "solver/execution/simd.hpp"

namespace recoat {

template <class Number, class Arch>
struct BitsOf<xsimd::batch<Number, Arch>> {
    using Real = Number;
    using Integer = xsimd::batch<typename BitsOf<Number>::Integer, Arch>;
    static RECOAT_HD Integer of(xsimd::batch<Number, Arch> x) { return xsimd::bitwise_cast<Integer>(x); }
    static RECOAT_HD xsimd::batch<Number, Arch> real(Integer bits) {
        return xsimd::bitwise_cast<xsimd::batch<Number, Arch>>(bits);
    }
};

template <class Number, class Arch>
struct Order<xsimd::batch<Number, Arch>> {
    using Pack = xsimd::batch<Number, Arch>;
    static RECOAT_HD Pack smaller(Pack a, Pack b) { return xsimd::min(a, b); }
    static RECOAT_HD Pack larger(Pack a, Pack b) { return xsimd::max(a, b); }
};

/// What AVX2 and AVX-512 have in common: rows are registers of 256 bits.
struct SimdRows {
    using Row = __m256d;
    using Motion = __m256;

    static RECOAT_HD Row row(const double* from) { return _mm256_loadu_pd(from); }
    static RECOAT_HD Row row_of(double x, double y, double z, double w) { return _mm256_setr_pd(x, y, z, w); }
    static RECOAT_HD Row spread(double x) { return _mm256_set1_pd(x); }
    static RECOAT_HD void store(double* to, Row row) { _mm256_storeu_pd(to, row); }
    static RECOAT_HD Row add(Row a, Row b) { return _mm256_add_pd(a, b); }
    static RECOAT_HD Row subtract(Row a, Row b) { return _mm256_sub_pd(a, b); }
    static RECOAT_HD Row multiply(Row a, Row b) { return _mm256_mul_pd(a, b); }
    static RECOAT_HD Row multiply_add(Row a, Row b, Row c) { return _mm256_fmadd_pd(a, b, c); }
    static RECOAT_HD Row with_fourth(Row a, double w) { return _mm256_blend_pd(a, _mm256_set1_pd(w), 8); }
    static RECOAT_HD double sum3(Row a) {
        const __m128d low = _mm256_castpd256_pd128(a), high = _mm256_extractf128_pd(a, 1);
        return _mm_cvtsd_f64(_mm_add_sd(_mm_add_sd(low, _mm_unpackhi_pd(low, low)), high));
    }

    static RECOAT_HD Motion motion(const float* from) { return _mm256_loadu_ps(from); }
    static RECOAT_HD Motion motion_of(Row velocity, Row spin) {
        return _mm256_set_m128(_mm256_cvtpd_ps(spin), _mm256_cvtpd_ps(velocity));
    }
    static RECOAT_HD void store(float* to, Motion m) { _mm256_storeu_ps(to, m); }
    static RECOAT_HD Motion relative(Motion a, Motion b) {
        const Motion sign = _mm256_setr_ps(-0.0f, -0.0f, -0.0f, -0.0f, 0.0f, 0.0f, 0.0f, 0.0f);
        return _mm256_add_ps(a, _mm256_xor_ps(b, sign));
    }
};

}  // namespace recoat
