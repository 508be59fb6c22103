#pragma once

#include "solver/execution/simd_rows.hpp"

namespace recoat {

template <>
struct Simd<Avx512> : SimdRows {
    using Arch = xsimd::avx512bw;
    static constexpr int doubles = 8, singles = 16;
    using Double = xsimd::batch<double, Arch>;
    using Single = xsimd::batch<float, Arch>;
    using SimdRows::store;

    static RECOAT_HD Double load(const double* from) { return Double::load_unaligned(from); }
    static RECOAT_HD Single load(const float* from) { return Single::load_unaligned(from); }
    static RECOAT_HD void store(double* to, Double x) { x.store_unaligned(to); }
    static RECOAT_HD void store(float* to, Single x) { x.store_unaligned(to); }
    static RECOAT_HD double sum(Double x) { return _mm512_reduce_add_pd(x); }
    static RECOAT_HD double sum(Single x) { return sum(Double(_mm512_add_pd(lower(x), upper(x)))); }
    static RECOAT_HD double highest(Double x) { return _mm512_reduce_max_pd(x); }
    static RECOAT_HD double highest(Single x) { return highest(Double(_mm512_max_pd(lower(x), upper(x)))); }
    static RECOAT_HD unsigned bits(xsimd::batch_bool<double, Arch> mask) { return static_cast<__mmask8>(mask); }
    static RECOAT_HD unsigned bits(xsimd::batch_bool<float, Arch> mask) { return static_cast<__mmask16>(mask); }

    /// Eight rows become four packs, and back.
    static RECOAT_HD void packs(const Row* r, Double& x, Double& y, Double& z, Double& w) {
        const __m512d r0 = pair(r[0], r[4]), r1 = pair(r[1], r[5]), r2 = pair(r[2], r[6]), r3 = pair(r[3], r[7]);
        const __m512d a = _mm512_unpacklo_pd(r0, r1), b = _mm512_unpackhi_pd(r0, r1);
        const __m512d c = _mm512_unpacklo_pd(r2, r3), d = _mm512_unpackhi_pd(r2, r3);
        x = even_lanes(a, c);
        y = even_lanes(b, d);
        z = odd_lanes(a, c);
        w = odd_lanes(b, d);
    }
    static RECOAT_HD void rows(Double x, Double y, Double z, Double w, Row* out) {
        const __m512d a = _mm512_unpacklo_pd(x, y), b = _mm512_unpackhi_pd(x, y);
        const __m512d c = _mm512_unpacklo_pd(z, w), d = _mm512_unpackhi_pd(z, w);
        const __m512d r[4] = {even_lanes(a, c), even_lanes(b, d), odd_lanes(a, c), odd_lanes(b, d)};
        for (int k = 0; k < 4; ++k) {
            out[k] = _mm512_castpd512_pd256(r[k]);
            out[k + 4] = _mm512_extractf64x4_pd(r[k], 1);
        }
    }
    /// Sixteen rows of doubles from packs of singles.
    static RECOAT_HD void rows(Single x, Single y, Single z, Single w, Row* out) {
        const __m512 a = _mm512_unpacklo_ps(x, y), b = _mm512_unpackhi_ps(x, y);
        const __m512 c = _mm512_unpacklo_ps(z, w), d = _mm512_unpackhi_ps(z, w);
        const __m512 r[4] = {_mm512_shuffle_ps(a, c, 0x44), _mm512_shuffle_ps(a, c, 0xee),
                             _mm512_shuffle_ps(b, d, 0x44), _mm512_shuffle_ps(b, d, 0xee)};
        for (int k = 0; k < 4; ++k) {
            // Lane l of the register is row 4 l + k.
            const __m512d low = lower(r[k]), high = upper(r[k]);
            out[k] = _mm512_castpd512_pd256(low);
            out[k + 4] = _mm512_extractf64x4_pd(low, 1);
            out[k + 8] = _mm512_castpd512_pd256(high);
            out[k + 12] = _mm512_extractf64x4_pd(high, 1);
        }
    }
    static RECOAT_HD Single narrow(const Double* x) {
        return Single(_mm512_insertf32x8(_mm512_castps256_ps512(_mm512_cvtpd_ps(x[0])), _mm512_cvtpd_ps(x[1]), 1));
    }

    /// Sixteen rows of eight singles become eight packs.
    static RECOAT_HD void packs(const Motion* in, Single* out) {
        for (int h = 0; h < 8; h += 4) {
            __m512 r[4];
            for (int k = 0; k < 4; ++k) r[k] = quarters(in[k], in[k + 4], in[k + 8], in[k + 12], h);
            const __m512 a = _mm512_unpacklo_ps(r[0], r[1]), b = _mm512_unpackhi_ps(r[0], r[1]);
            const __m512 c = _mm512_unpacklo_ps(r[2], r[3]), d = _mm512_unpackhi_ps(r[2], r[3]);
            out[h] = _mm512_shuffle_ps(a, c, 0x44);
            out[h + 1] = _mm512_shuffle_ps(a, c, 0xee);
            out[h + 2] = _mm512_shuffle_ps(b, d, 0x44);
            out[h + 3] = _mm512_shuffle_ps(b, d, 0xee);
        }
    }

private:
    static RECOAT_HD __m512d lower(__m512 x) { return _mm512_cvtps_pd(_mm512_castps512_ps256(x)); }
    static RECOAT_HD __m512d upper(__m512 x) { return _mm512_cvtps_pd(_mm512_extractf32x8_ps(x, 1)); }
    static RECOAT_HD __m512d pair(__m256d low, __m256d high) {
        return _mm512_insertf64x4(_mm512_castpd256_pd512(low), high, 1);
    }
    /// Lanes of 128 bits: 0 and 2 of each, then 1 and 3, so that a pack keeps the order of its rows.
    static RECOAT_HD __m512d even_lanes(__m512d a, __m512d b) {
        return _mm512_permutex2var_pd(a, _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13), b);
    }
    static RECOAT_HD __m512d odd_lanes(__m512d a, __m512d b) {
        return _mm512_permutex2var_pd(a, _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15), b);
    }
    /// The first (`half` = 0) or second half of four rows side by side.
    static RECOAT_HD __m512 quarters(__m256 a, __m256 b, __m256 c, __m256 d, int half) {
        const int from = half == 0 ? 0x20 : 0x31;
        const __m256 low = from == 0x20 ? _mm256_permute2f128_ps(a, b, 0x20) : _mm256_permute2f128_ps(a, b, 0x31);
        const __m256 high = from == 0x20 ? _mm256_permute2f128_ps(c, d, 0x20) : _mm256_permute2f128_ps(c, d, 0x31);
        return _mm512_insertf32x8(_mm512_castps256_ps512(low), high, 1);
    }
};

}  // namespace recoat
