#pragma once

#include <bit>
#include <cstdint>

#include "common/host_device.hpp"

namespace recoat {

/// x^(1/3) for x >= 0, to 1e-11; 0 for x below 1e-290.
///
/// Written out, because a library call would keep the pair loop from being vectorised and would differ between host
/// and device. A third of the exponent bits is the first guess (5 % off); each Halley step triples its digits, and two
/// are enough for the stiffness of a friction spring.
RECOAT_HD double cube_root(double x) {
    const double safe = x > 1e-290 ? x : 1;
    // The division of the 64-bit pattern by 3 is done on the upper half, in floating point, where lanes have it.
    const auto high = static_cast<std::int32_t>(std::bit_cast<std::uint64_t>(safe) >> 32);
    const auto third = static_cast<std::int32_t>(static_cast<double>(high) * (1.0 / 3.0)) + 715094163;
    double y = std::bit_cast<double>(static_cast<std::uint64_t>(static_cast<std::uint32_t>(third)) << 32);
    for (int step = 0; step < 2; ++step) {
        const double cube = y * y * y;
        y = y * ((cube + 2 * safe) / (2 * cube + safe));  // the quotient first: it stays near 1
    }
    return x > 1e-290 ? y : 0;
}

}  // namespace recoat
