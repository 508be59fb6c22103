#pragma once

#include <cmath>

#include "common/host_device.hpp"

namespace recoat {

/// Three Cartesian components. `T` is a number, or a pack of numbers for as many vectors. Trivially copyable: the same
/// type crosses to a device.
template <class T>
struct Vec3Of {
    T x{}, y{}, z{};

    friend bool operator==(const Vec3Of&, const Vec3Of&) = default;

    friend RECOAT_HD Vec3Of operator+(Vec3Of a, Vec3Of b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend RECOAT_HD Vec3Of operator-(Vec3Of a, Vec3Of b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend RECOAT_HD Vec3Of operator-(Vec3Of a) { return {-a.x, -a.y, -a.z}; }
    friend RECOAT_HD Vec3Of operator*(T s, Vec3Of a) { return {s * a.x, s * a.y, s * a.z}; }
    friend RECOAT_HD Vec3Of& operator+=(Vec3Of& a, Vec3Of b) { return a = a + b; }

    friend RECOAT_HD T dot(Vec3Of a, Vec3Of b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
    friend RECOAT_HD Vec3Of cross(Vec3Of a, Vec3Of b) {
        return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    }
    friend RECOAT_HD T squared_norm(Vec3Of a) { return dot(a, a); }
    friend RECOAT_HD T norm(Vec3Of a) {
        using std::sqrt;
        return sqrt(dot(a, a));
    }
};

using Vec3 = Vec3Of<double>;

}  // namespace recoat
