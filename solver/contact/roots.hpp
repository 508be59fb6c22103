#pragma once

#include <cstdint>

#include "common/bits_of.hpp"

namespace recoat {

/// First guesses of x^(-1/n) by the bit pattern, which is a logarithm of base 2 with straight pieces: a shift or a
/// product takes the root. They are 3.4 % off at most; what is left follows from a polynomial in r = 1 - x y^n.
template <class Real>
struct RootGuess;

template <>
struct RootGuess<double> {
    static constexpr std::uint64_t second = 0x5fe6eb50c0000000;
    static constexpr std::uint64_t fourth = 0x4feb05d400000000;
    static constexpr std::uint64_t sixth = 0x4a9709ef95555555;
    static constexpr int dropped = 12;                          // bits, so that the rest fits a mantissa
    static constexpr std::uint64_t whole = 0x4330000000000000;  // 2^52: its last digit is worth 1
};

template <>
struct RootGuess<float> {
    static constexpr std::uint32_t second = 0x5f375a86;
    static constexpr std::uint32_t fourth = 0x4f582ea0;
    static constexpr std::uint32_t sixth = 0x4a0da4d2;
    static constexpr int dropped = 9;
    static constexpr std::uint32_t whole = 0x4b000000;  // 2^23
};

/// c0 + c1 r + ... + c5 r^5 ~ (1 - r)^(-1/n): minimax polynomials in the relative error over what r can be after the
/// guess, by Remez' algorithm. Largest errors: 7.3e-10, 8.2e-9, 4.1e-8.
template <class T>
RECOAT_HD T second_root_series(T r) {
    return T(1.0000000007269596) +
           r * (T(0.49999999804288892) +
                r * (T(0.37499720659350999) +
                     r * (T(0.31250084506501785) + r * (T(0.27502727252413761) + r * T(0.24677917252058246)))));
}
template <class T>
RECOAT_HD T fourth_root_series(T r) {
    return T(1.0000000082022731) +
           r * (T(0.24999999923190941) +
                r * (T(0.15624042203918651) +
                     r * (T(0.1171840300593894) + r * (T(0.096869306155579801) + r * T(0.081991163247565474)))));
}
template <class T>
RECOAT_HD T sixth_root_series(T r) {
    return T(1.0000000402690958) +
           r * (T(0.16666699814548774) +
                r * (T(0.097199273292775668) +
                     r * (T(0.070151733519489626) + r * (T(0.057518719184957809) + r * T(0.049312408475881177)))));
}

/// x^(-1/2) for x >= 0, to two units in the last place; large but finite at 0, so that x times it is the root there
/// too.
///
/// Neither a root nor a division: those occupy a processor's only divider, which bounded the contact pass, and this
/// gives both at once. The same operations in the same order for numbers, packs of any width and devices.
template <class T>
RECOAT_HD T inverse_root(T x) {
    using Bits = BitsOf<T>;
    using Real = typename Bits::Real;
    T y = Bits::real(RootGuess<Real>::second - (Bits::of(x) >> 1));
    y = y * second_root_series<T>(T(1) - (x * y) * y);
    if constexpr (sizeof(Real) == 8) y = y + (y * T(0.5)) * (T(1) - (x * y) * y);
    return y;
}

/// x^(-1/4) for x >= 0, likewise; its second and fourth power are x^(-1/2) and 1/x.
template <class T>
RECOAT_HD T inverse_fourth_root(T x) {
    using Bits = BitsOf<T>;
    using Real = typename Bits::Real;
    T y = Bits::real(RootGuess<Real>::fourth - (Bits::of(x) >> 2));
    T square = y * y;
    y = y * fourth_root_series<T>(T(1) - (x * square) * square);
    if constexpr (sizeof(Real) == 8) {
        square = y * y;
        y = y + (y * T(0.25)) * (T(1) - (x * square) * square);
    }
    return y;
}

/// x^(-1/6) for x >= 0, likewise; x times its fourth and fifth power are the cube root and the sixth root.
template <class T>
RECOAT_HD T inverse_sixth_root(T x) {
    using Bits = BitsOf<T>;
    using Real = typename Bits::Real;
    using Guess = RootGuess<Real>;
    // Packs have no division of integers: the upper bits become a whole number in floating point.
    const T whole = Bits::real(typename Bits::Integer(Guess::whole));
    const T upper = Bits::real(typename Bits::Integer(Guess::whole) | (Bits::of(x) >> Guess::dropped)) - whole;
    T z = Bits::real(Guess::sixth - (Bits::of(whole + upper * T(1.0 / 6)) << Guess::dropped));
    T cube = z * z * z;
    z = z * sixth_root_series<T>(T(1) - (x * cube) * cube);
    if constexpr (sizeof(Real) == 8) {
        cube = z * z * z;
        const T rest = T(1) - (x * cube) * cube;
        z = z + (z * rest) * (T(1.0 / 6) + T(7.0 / 72) * rest);
    }
    return z;
}

}  // namespace recoat
