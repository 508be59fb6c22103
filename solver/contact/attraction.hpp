#pragma once

#include <cmath>

#include "common/select.hpp"
#include "solver/contact/coefficients.hpp"

namespace recoat {

/// van der Waals attraction between spheres, or sphere and wall, cut off at both ends [paper eq. 6]; in contact it is
/// that of the reduced Hamaker constant [paper eq. 7; docs/physics.md sections 2.3, 2.4].
///
///   F(s) = F_r (s < 0),  F_o (0 <= s < s_min),  F_o s_min^2 / s^2 (s_min <= s <= s_max),  0 beyond       [N]
///
/// `Real` is the type of its numbers; the functions take numbers or packs of them.
template <class Real>
struct AttractionOf {
    Real minimum_separation = 0;  ///< s_min [m]
    Real cut_off = 0;             ///< s_max [m]

    template <class T, class C>
    RECOAT_HD T force(T s, const C& c) const {
        // Flat selects only: nested ones keep the compiler from making vectors.
        const T strength = select(s < T(0), T(c.attraction_contact), T(c.attraction_gap));
        const T ratio = T(minimum_separation) / larger(s, T(minimum_separation));
        return select(s <= T(cut_off), strength * ratio * ratio, T(0));
    }

    /// G(s): work of the attraction between s and s_max, the depth of the well [J].
    template <class T, class C>
    RECOAT_HD T well(T s, const C& c) const {
        const T strength = T(c.attraction_gap) * minimum_separation * minimum_separation;
        const T far = clamped(s, T(minimum_separation), T(cut_off));
        const T gap = clamped(s, T(0), T(minimum_separation));
        const T overlap = larger(-s, T(0));
        return strength * (T(1) / far - T(1 / cut_off)) + c.attraction_gap * (T(minimum_separation) - gap) +
               c.attraction_contact * overlap;
    }

    /// Mean attraction over the path from s0 to s1: (G(s1) - G(s0)) / (s0 - s1) without its cancellation
    /// [docs/physics.md section 2.4].
    template <class T, class C>
    RECOAT_HD T mean(T s0, T s1, const C& c) const {
        const T least = T(minimum_separation), most = T(cut_off);
        const T contact = smaller(s1, T(0)) - smaller(s0, T(0));
        const T gap = clamped(s1, T(0), least) - clamped(s0, T(0), least);
        const T far0 = clamped(s0, least, most), far1 = clamped(s1, least, most);
        // s_min/s one by one: their squares would be too small for single precision.
        const T far = (least / far0) * (least / far1) * (far1 - far0);
        const T work = c.attraction_contact * contact + c.attraction_gap * (gap + far);
        const T path = s1 - s0;
        const T local = force(T(0.5) * (s0 + s1), c);
        const auto standing = abs_of(path) < T(shortest_path);
        return select(standing, local, work / select(standing, T(1), path));
    }

    static constexpr Real shortest_path = 1e-18;  ///< below it the force at the middle stands for the mean [m]

private:
    template <class T>
    static RECOAT_HD T abs_of(T x) {
        using std::abs;
        return abs(x);
    }
};

using Attraction = AttractionOf<double>;

}  // namespace recoat
