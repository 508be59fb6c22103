#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "common/bits_of.hpp"
#include "common/select.hpp"
#include "solver/execution/instruction_set.hpp"

namespace recoat {

/// Vector types of an instruction set, and how rows of an array become packs and packs rows.
///
/// `Double` and `Single` are packs of `doubles` and `singles` numbers, `Row` is four doubles and `Motion` eight singles
/// that lie side by side in memory.
template <class Set>
struct Simd;

/// Four doubles without vector registers.
struct PlainRow {
    double value[4] = {};
};

/// Eight singles without vector registers.
struct PlainMotion {
    float value[8] = {};
};

/// Any machine: a pack is one number.
template <>
struct Simd<Baseline> {
    static constexpr int doubles = 1, singles = 1;
    using Double = double;
    using Single = float;
    using Row = PlainRow;
    using Motion = PlainMotion;

    template <class T>
    static RECOAT_HD T load(const T* from) {
        return *from;
    }
    template <class T>
    static RECOAT_HD void store(T* to, T value) {
        *to = value;
    }
    static RECOAT_HD double sum(double x) { return x; }
    static RECOAT_HD double sum(float x) { return static_cast<double>(x); }
    static RECOAT_HD double highest(double x) { return x; }
    static RECOAT_HD double highest(float x) { return static_cast<double>(x); }
    static RECOAT_HD unsigned bits(bool mask) { return mask ? 1 : 0; }

    static RECOAT_HD Row row(const double* from) { return {{from[0], from[1], from[2], from[3]}}; }
    static RECOAT_HD Row row_of(double x, double y, double z, double w) { return {{x, y, z, w}}; }
    static RECOAT_HD Row spread(double x) { return row_of(x, x, x, x); }
    static RECOAT_HD void store(double* to, const Row& row) {
        for (int c = 0; c < 4; ++c) to[c] = row.value[c];
    }
    static RECOAT_HD Row add(const Row& a, const Row& b) {
        return each(a, b, [](double x, double y) { return x + y; });
    }
    static RECOAT_HD Row subtract(const Row& a, const Row& b) {
        return each(a, b, [](double x, double y) { return x - y; });
    }
    static RECOAT_HD Row multiply(const Row& a, const Row& b) {
        return each(a, b, [](double x, double y) { return x * y; });
    }
    /// a b + c
    static RECOAT_HD Row multiply_add(const Row& a, const Row& b, const Row& c) { return add(multiply(a, b), c); }
    static RECOAT_HD Row with_fourth(const Row& a, double w) { return {{a.value[0], a.value[1], a.value[2], w}}; }
    /// Sum of the first three.
    static RECOAT_HD double sum3(const Row& a) { return a.value[0] + a.value[1] + a.value[2]; }

    static RECOAT_HD void packs(const Row* rows, double& x, double& y, double& z, double& w) {
        x = rows->value[0];
        y = rows->value[1];
        z = rows->value[2];
        w = rows->value[3];
    }
    static RECOAT_HD void rows(double x, double y, double z, double w, Row* out) { *out = row_of(x, y, z, w); }
    static RECOAT_HD void rows(float x, float y, float z, float w, Row* out) { *out = row_of(x, y, z, w); }
    static RECOAT_HD float narrow(const double* x) { return static_cast<float>(*x); }

    static RECOAT_HD Motion motion(const float* from) {
        Motion m;
        for (int c = 0; c < 8; ++c) m.value[c] = from[c];
        return m;
    }
    static RECOAT_HD Motion motion_of(const Row& velocity, const Row& spin) {
        Motion m;
        for (int c = 0; c < 4; ++c) {
            m.value[c] = static_cast<float>(velocity.value[c]);
            m.value[4 + c] = static_cast<float>(spin.value[c]);
        }
        return m;
    }
    static RECOAT_HD void store(float* to, const Motion& m) {
        for (int c = 0; c < 8; ++c) to[c] = m.value[c];
    }
    /// First half of a minus that of b, second half of a plus that of b.
    static RECOAT_HD Motion relative(const Motion& a, const Motion& b) {
        Motion m;
        for (int c = 0; c < 4; ++c) {
            m.value[c] = a.value[c] - b.value[c];
            m.value[4 + c] = a.value[4 + c] + b.value[4 + c];
        }
        return m;
    }
    static RECOAT_HD void packs(const Motion* rows, float* out) {
        for (int c = 0; c < 8; ++c) out[c] = rows->value[c];
    }

private:
    template <class Function>
    static RECOAT_HD Row each(const Row& a, const Row& b, const Function& f) {
        Row r;
        for (int c = 0; c < 4; ++c) r.value[c] = f(a.value[c], b.value[c]);
        return r;
    }
};

}  // namespace recoat
