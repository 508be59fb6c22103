#pragma once

#include "solver/contact/attraction.hpp"
#include "solver/contact/roots.hpp"

namespace recoat {

/// b = dt^2 / (2 m*): a force F shortens the path of the step by b F [m/N].
template <class T, class C, class Real>
RECOAT_HD T path_per_force(const C& c, Real time_step) {
    return T(Real(0.5) * time_step) * (T(time_step) * c.inverse_mass);
}

/// Solves of a step after the first, in each of which every pair sees what the impulses of the one before do to its
/// partners: a particle that others hold would else let go early, and bound ones gain energy [docs/physics.md 2.5].
inline constexpr int corrections_of_impulses = 1;

/// What the rate of a pair, that half of all impulses of a step are in, is without half of that of its own `force`
/// [m/s]: what the solve of the pair by itself begins from.
template <class T, class C, class Real>
RECOAT_HD T rate_without(T force, T rate, const C& c, Real time_step) {
    return rate + T(Real(0.5) * time_step) * (force * T(c.inverse_mass));
}

/// Mean attraction of a step that crosses s = 0 and stays below s_min; `otherwise` for any other step.
///
/// The force jumps at s = 0, so that the fixed point and the secant do not converge for slow crossings. There
/// s1 = free - b F(s0, s1) is a quadratic: with the constant forces A on the side of s0 and B on the other side
/// s1^2 - (s0 + free - b B) s1 + s0 (free - b A) = 0, and the step crosses iff s0 (free - b A) < 0.
template <class Real, class T, class C>
RECOAT_HD T crossing_force(const AttractionOf<Real>& attraction, T s0, T free, T b, const C& c, T otherwise) {
    const auto inside = s0 < T(0);
    const T here = select(inside, T(c.attraction_contact), T(c.attraction_gap));
    const T there = select(inside, T(c.attraction_gap), T(c.attraction_contact));
    const T half = T(0.5) * (s0 + free - b * there);
    // Lengths go in multiples of s_min, or their squares would be too small for single precision.
    const T unit = T(1 / attraction.minimum_separation);
    const T product = (unit * s0) * (unit * (free - b * here));
    const T square = larger((unit * half) * (unit * half) - product, T(0));
    const T root = T(attraction.minimum_separation) * (square * inverse_root(square));
    const T end = half + select(inside, root, -root);
    const T force = select(product < T(0), attraction.mean(s0, end, c), otherwise);
    return select(larger(s0, end) < T(attraction.minimum_separation), force, otherwise);
}

/// The discrete-gradient impulse, for contact and non-contact pairs alike [docs/physics.md section 2.5]:
/// solve  s1 = s0 + u* dt - b F(s0, s1),  b = dt^2 / (2 m*).  The energy of an isolated pair is then exact at any step.
///
/// `iterations` of the fixed point contract by b F_o / s_min each: enough for small steps.
template <int iterations, class Real = double>
struct FixedPointImpulse {
    static constexpr bool half_step_positions = true;
    AttractionOf<Real> attraction;
    Real time_step;

    template <class T, class C>
    RECOAT_HD T operator()(T s0, T u, const C& c) const {
        const T b = path_per_force<T>(c, time_step);
        const T free = s0 + u * T(time_step);
        T force = attraction.mean(s0, free, c);
        for (int i = 0; i < iterations; ++i) force = attraction.mean(s0, free - b * force, c);
        return crossing_force(attraction, s0, free, b, c, force);
    }
};

/// The same equation by the secant method on  F -> F(s0, free - b F) - F,  for steps where the fixed point is slow: the
/// digits grow by half as much again with each of the `evaluations`, where the fixed point only adds to them.
template <int evaluations, class Real = double>
struct SecantImpulse {
    static constexpr bool half_step_positions = true;
    AttractionOf<Real> attraction;
    Real time_step;

    template <class T, class C>
    RECOAT_HD T operator()(T s0, T u, const C& c) const {
        const T b = path_per_force<T>(c, time_step);
        const T free = s0 + u * T(time_step);
        const T strongest = larger(T(c.attraction_gap), T(c.attraction_contact));
        T before = attraction.mean(s0, free, c);
        T force = attraction.mean(s0, free - b * before, c);
        T change_before = force - before;
        RECOAT_UNROLL
        for (int i = 0; i < evaluations; ++i) {
            const T change = attraction.mean(s0, free - b * force, c) - force;
            const T slope = change - change_before;
            // A slope of nothing means that both are the root already; the plain fixed point is then as good.
            const auto moved = slope != T(0);
            const T ratio = (force - before) / select(moved, slope, T(-1));
            const T step = select(moved, -(change * ratio), change);
            before = force;
            change_before = change;
            force = clamped(force + step, T(0), strongest);
        }
        return crossing_force(attraction, s0, free, b, c, force);
    }
};

/// The same equation by a bracketed secant (Illinois), for steps where the fixed point converges slowly or not at all.
template <class Real = double>
struct BracketedImpulse {
    static constexpr bool half_step_positions = true;
    static constexpr int iterations = 14;
    AttractionOf<Real> attraction;
    Real time_step;

    template <class T, class C>
    RECOAT_HD T operator()(T s0, T u, const C& c) const {
        const T b = path_per_force<T>(c, time_step);
        const T free = s0 + u * T(time_step);
        const T strongest = larger(T(c.attraction_gap), T(c.attraction_contact));
        T lower = free - b * strongest, upper = free;
        T below = lower - free + b * attraction.mean(s0, lower, c);
        T above = b * attraction.mean(s0, upper, c);
        T root = upper, side = T(0);
        for (int i = 0; i < iterations; ++i) {
            const T slope = above - below;
            const auto rising = slope > T(0);
            root = select(rising, (lower * above - upper * below) / select(rising, slope, T(1)), upper);
            const T value = root - free + b * attraction.mean(s0, root, c);
            const auto high = value > T(0);
            upper = select(high, root, upper);
            lower = select(high, lower, root);
            // An end kept twice has its value halved, or the secant would creep.
            const T low_value = select(side > T(0.5), T(0.5) * below, below);
            const T high_value = select(side < T(-0.5), T(0.5) * above, above);
            below = select(high, low_value, value);
            above = select(high, value, high_value);
            side = select(high, T(1), T(-1));
        }
        return crossing_force(attraction, s0, free, b, c, attraction.mean(s0, root, c));
    }
};

/// The plain explicit force at the separation of the step's start. Kept for comparison.
template <class Real = double>
struct ExplicitImpulse {
    static constexpr bool half_step_positions = false;
    AttractionOf<Real> attraction;
    Real time_step;

    template <class T, class C>
    RECOAT_HD T operator()(T s0, T, const C& c) const {
        return attraction.force(s0, c);
    }
};

/// The paper's prediction-correction [eq. 9] as read in docs/physics.md section 2.5: the predicted travel s0 -> s0 + u*
/// dt does its work, out of contact only; where the well cannot be left, the velocity is reflected. Kept for
/// comparison.
template <class Real = double>
struct PredictionCorrectionImpulse {
    static constexpr bool half_step_positions = false;
    AttractionOf<Real> attraction;
    Real time_step;

    template <class T, class C>
    RECOAT_HD T operator()(T s0, T u, const C& c) const {
        using std::sqrt;
        const T end = larger(s0 + u * T(time_step), T(0));
        const T work = attraction.well(end, c) - attraction.well(larger(s0, T(0)), c);
        const T square = u * u + T(2) * work * c.inverse_mass;
        const T speed = sqrt(larger(square, T(0)));
        const T corrected = select(square > T(0), select(u < T(0), -speed, speed), -u);
        const T force = (u - corrected) / (c.inverse_mass * T(time_step));
        return select(s0 < T(0), T(c.attraction_contact), select(u != T(0), force, T(0)));
    }
};

}  // namespace recoat
