#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "common/vec3.hpp"

namespace recoat::stress {

/// Random choices that are the same with every library: a generator fixed by the C++ standard, its bits used directly.
/// One draw per expression, since the order of evaluation within one is not fixed.
class Draw {
public:
    /// Scene number `index` of the run with this seed; scenes do not depend on each other.
    Draw(std::uint64_t seed, std::uint64_t index) {
        std::seed_seq sequence{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                               static_cast<std::uint32_t>(index), static_cast<std::uint32_t>(index >> 32)};
        generator_.seed(sequence);
    }

    /// Uniform in [0, 1).
    double unit() { return static_cast<double>(generator_() >> 11) * 0x1.0p-53; }
    double between(double lower, double upper) { return lower + (upper - lower) * unit(); }
    /// Uniform in the logarithm.
    double decades(double lower, double upper) { return lower * std::pow(upper / lower, unit()); }
    /// A whole number from `lower` to `upper`, both included.
    int whole(int lower, int upper) { return lower + static_cast<int>(unit() * (upper - lower + 1)); }
    bool chance(double share) { return unit() < share; }
    template <class Value>
    Value pick(const std::vector<Value>& values) {
        return values[static_cast<std::size_t>(unit() * static_cast<double>(values.size()))];
    }
    /// A direction, uniform on the sphere.
    Vec3 direction() {
        const double z = between(-1, 1), angle = between(0, 2 * 3.14159265358979323846);
        const double ring = std::sqrt(1 - z * z);
        return {ring * std::cos(angle), ring * std::sin(angle), z};
    }

private:
    std::mt19937_64 generator_;
};

}  // namespace recoat::stress
