#pragma once

#include <cmath>

#include "common/host_device.hpp"

namespace recoat {

/// Three Cartesian components in double precision. Trivially copyable: the same type crosses to a device.
struct Vec3 {
    double x = 0, y = 0, z = 0;

    friend bool operator==(const Vec3&, const Vec3&) = default;
};

RECOAT_HD Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
RECOAT_HD Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
RECOAT_HD Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
RECOAT_HD Vec3 operator*(double s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
RECOAT_HD Vec3& operator+=(Vec3& a, Vec3 b) { return a = a + b; }

RECOAT_HD double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
RECOAT_HD Vec3 cross(Vec3 a, Vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
RECOAT_HD double squared_norm(Vec3 a) { return dot(a, a); }
RECOAT_HD double norm(Vec3 a) { return std::sqrt(dot(a, a)); }

}  // namespace recoat
