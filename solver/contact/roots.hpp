#pragma once

#include <cstdint>

#include "common/bits_of.hpp"

namespace recoat {

/// First guesses by the bit pattern, which is a logarithm of base 2 with straight pieces: halving it or taking a sixth
/// of it takes the root.
template <class Real>
struct RootGuess;

template <>
struct RootGuess<double> {
    static constexpr std::uint64_t inverse_root = 0x5fe6eb50c7b537a9;        // 3.4 % off at most
    static constexpr std::uint64_t inverse_sixth_root = 0x4a971da651640792;  // 3.1 % off at most
    static constexpr int dropped = 12;                                       // bits, so that the rest fits a mantissa
    static constexpr std::uint64_t whole = 0x4330000000000000;               // 2^52: its last digit is worth 1
    static constexpr int steps = 2, sixth_steps = 2;  // before the last, which doubles the digits
};

template <>
struct RootGuess<float> {
    static constexpr std::uint32_t inverse_root = 0x5f375a86;
    static constexpr std::uint32_t inverse_sixth_root = 0x4a0e4112;
    static constexpr int dropped = 9;
    static constexpr std::uint32_t whole = 0x4b000000;  // 2^23
    static constexpr int steps = 1, sixth_steps = 2;
};

/// x^(-1/2) for x >= 0, to two units in the last place; large but finite at 0, so that x times it is the root there
/// too.
///
/// Neither a root nor a division: those occupy a processor's only divider, which bounded the contact pass, and this
/// gives both at once. Householder's steps on y^-2 - x treble the digits, Newton's at the end doubles them. The same
/// operations in the same order for numbers, packs of any width and devices.
template <class T>
RECOAT_HD T inverse_root(T x) {
    using Bits = BitsOf<T>;
    using Guess = RootGuess<typename Bits::Real>;
    T y = Bits::real(Guess::inverse_root - (Bits::of(x) >> 1));
    RECOAT_UNROLL
    for (int step = 0; step < Guess::steps; ++step) {
        const T rest = T(1) - (x * y) * y;
        y = y + (y * rest) * (T(0.5) + T(0.375) * rest);
    }
    return y + (y * T(0.5)) * (T(1) - (x * y) * y);
}

/// x^(-1/6) for x >= 0, likewise; x times its fourth and fifth power are the cube root and the sixth root.
template <class T>
RECOAT_HD T inverse_sixth_root(T x) {
    using Bits = BitsOf<T>;
    using Guess = RootGuess<typename Bits::Real>;
    // Packs have no division of integers: the upper bits become a whole number in floating point.
    const T whole = Bits::real(typename Bits::Integer(Guess::whole));
    const T upper = Bits::real(typename Bits::Integer(Guess::whole) | (Bits::of(x) >> Guess::dropped)) - whole;
    T z = Bits::real(Guess::inverse_sixth_root - (Bits::of(whole + upper * T(1.0 / 6)) << Guess::dropped));
    RECOAT_UNROLL
    for (int step = 0; step < Guess::sixth_steps; ++step) {
        const T cube = z * z * z;
        const T rest = T(1) - (x * cube) * cube;
        z = z + (z * rest) * (T(1.0 / 6) + T(7.0 / 72) * rest);
    }
    const T cube = z * z * z;
    return z + (z * T(1.0 / 6)) * (T(1) - (x * cube) * cube);
}

}  // namespace recoat
