#pragma once

#include "solver/execution/simd_rows.hpp"

namespace recoat {

template <>
struct Simd<Avx2> : SimdRows {
    using Arch = xsimd::fma3<xsimd::avx2>;
    static constexpr int doubles = 4, singles = 8;
    using Double = xsimd::batch<double, Arch>;
    using Single = xsimd::batch<float, Arch>;
    using SimdRows::store;

    static RECOAT_HD Double load(const double* from) { return Double::load_unaligned(from); }
    static RECOAT_HD Single load(const float* from) { return Single::load_unaligned(from); }
    static RECOAT_HD void store(double* to, Double x) { x.store_unaligned(to); }
    static RECOAT_HD void store(float* to, Single x) { x.store_unaligned(to); }
    static RECOAT_HD double sum(Double x) {
        const __m128d half = _mm_add_pd(_mm256_castpd256_pd128(x), _mm256_extractf128_pd(x, 1));
        return _mm_cvtsd_f64(_mm_add_sd(half, _mm_unpackhi_pd(half, half)));
    }
    static RECOAT_HD double sum(Single x) {
        return sum(Double(
            _mm256_add_pd(_mm256_cvtps_pd(_mm256_castps256_ps128(x)), _mm256_cvtps_pd(_mm256_extractf128_ps(x, 1)))));
    }
    static RECOAT_HD double highest(Double x) {
        const __m128d half = _mm_max_pd(_mm256_castpd256_pd128(x), _mm256_extractf128_pd(x, 1));
        return _mm_cvtsd_f64(_mm_max_sd(half, _mm_unpackhi_pd(half, half)));
    }
    static RECOAT_HD double highest(Single x) {
        return highest(Double(
            _mm256_max_pd(_mm256_cvtps_pd(_mm256_castps256_ps128(x)), _mm256_cvtps_pd(_mm256_extractf128_ps(x, 1)))));
    }
    static RECOAT_HD unsigned bits(xsimd::batch_bool<double, Arch> mask) {
        return static_cast<unsigned>(_mm256_movemask_pd(mask));
    }
    static RECOAT_HD unsigned bits(xsimd::batch_bool<float, Arch> mask) {
        return static_cast<unsigned>(_mm256_movemask_ps(mask));
    }

    /// Four rows become four packs, and back.
    static RECOAT_HD void packs(const Row* rows, Double& x, Double& y, Double& z, Double& w) {
        transpose(rows[0], rows[1], rows[2], rows[3], x, y, z, w);
    }
    static RECOAT_HD void rows(Double x, Double y, Double z, Double w, Row* out) {
        Double r[4];
        transpose(x, y, z, w, r[0], r[1], r[2], r[3]);
        for (int k = 0; k < 4; ++k) out[k] = r[k];
    }
    /// Eight rows of doubles from packs of singles.
    static RECOAT_HD void rows(Single x, Single y, Single z, Single w, Row* out) {
        const __m256 a = _mm256_unpacklo_ps(x, y), b = _mm256_unpackhi_ps(x, y);
        const __m256 c = _mm256_unpacklo_ps(z, w), d = _mm256_unpackhi_ps(z, w);
        const __m256 r[4] = {_mm256_shuffle_ps(a, c, 0x44), _mm256_shuffle_ps(a, c, 0xee),
                             _mm256_shuffle_ps(b, d, 0x44), _mm256_shuffle_ps(b, d, 0xee)};
        for (int k = 0; k < 4; ++k) {
            out[k] = _mm256_cvtps_pd(_mm256_castps256_ps128(r[k]));
            out[k + 4] = _mm256_cvtps_pd(_mm256_extractf128_ps(r[k], 1));
        }
    }
    static RECOAT_HD Single narrow(const Double* x) {
        return Single(_mm256_set_m128(_mm256_cvtpd_ps(x[1]), _mm256_cvtpd_ps(x[0])));
    }

    /// Eight rows of eight singles become eight packs.
    static RECOAT_HD void packs(const Motion* in, Single* out) {
        __m256 half[8];
        for (int k = 0; k < 4; ++k) {
            // Rows k and k + 4 side by side, first their first halves, then their second ones.
            half[k] = _mm256_permute2f128_ps(in[k], in[k + 4], 0x20);
            half[k + 4] = _mm256_permute2f128_ps(in[k], in[k + 4], 0x31);
        }
        for (int h = 0; h < 8; h += 4) {
            const __m256 a = _mm256_unpacklo_ps(half[h], half[h + 1]), b = _mm256_unpackhi_ps(half[h], half[h + 1]);
            const __m256 c = _mm256_unpacklo_ps(half[h + 2], half[h + 3]);
            const __m256 d = _mm256_unpackhi_ps(half[h + 2], half[h + 3]);
            out[h] = _mm256_shuffle_ps(a, c, 0x44);
            out[h + 1] = _mm256_shuffle_ps(a, c, 0xee);
            out[h + 2] = _mm256_shuffle_ps(b, d, 0x44);
            out[h + 3] = _mm256_shuffle_ps(b, d, 0xee);
        }
    }

private:
    static RECOAT_HD void transpose(__m256d r0, __m256d r1, __m256d r2, __m256d r3, Double& x, Double& y, Double& z,
                                    Double& w) {
        const __m256d a = _mm256_unpacklo_pd(r0, r1), b = _mm256_unpackhi_pd(r0, r1);
        const __m256d c = _mm256_unpacklo_pd(r2, r3), d = _mm256_unpackhi_pd(r2, r3);
        x = _mm256_permute2f128_pd(a, c, 0x20);
        y = _mm256_permute2f128_pd(b, d, 0x20);
        z = _mm256_permute2f128_pd(a, c, 0x31);
        w = _mm256_permute2f128_pd(b, d, 0x31);
    }
};

}  // namespace recoat
