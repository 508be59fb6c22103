#pragma once

#include <cmath>

#include "solver/contact/attraction.hpp"

namespace recoat {

/// Mean attraction of a step that crosses s = 0 and stays below s_min; `otherwise` for any other step.
///
/// The force jumps at s = 0, so that the fixed point and the secant do not converge for slow crossings. There
/// s1 = free - b F(s0, s1) is a quadratic: with the constant forces A on the side of s0 and B on the other side
/// s1^2 - (s0 + free - b B) s1 + s0 (free - b A) = 0, and the step crosses iff s0 (free - b A) < 0.
RECOAT_HD double crossing_force(const Attraction& attraction, double s0, double free, double b, const Coefficients& c,
                                double otherwise) {
    const double here = s0 < 0 ? c.attraction_contact : c.attraction_gap;
    const double there = s0 < 0 ? c.attraction_gap : c.attraction_contact;
    const double half = 0.5 * (s0 + free - b * there);
    const double product = s0 * (free - b * here);
    const double square = half * half - product;
    const double root = std::sqrt(square > 0 ? square : 0);
    const double end = half + (s0 < 0 ? root : -root);
    const double force = product < 0 ? attraction.mean(s0, end, c) : otherwise;
    return (s0 < end ? end : s0) < attraction.minimum_separation ? force : otherwise;
}

/// The discrete-gradient impulse, for contact and non-contact pairs alike [docs/physics.md section 2.5]:
/// solve  s1 = s0 + u* dt - b F(s0, s1),  b = dt^2 / (2 m*).  The energy of an isolated pair is then exact at any step.
///
/// `iterations` of the fixed point contract by b F_o / s_min each: enough for small steps.
template <int iterations>
struct FixedPointImpulse {
    static constexpr bool half_step_positions = true;
    Attraction attraction;
    double time_step;

    RECOAT_HD double operator()(double s0, double u, const Coefficients& c) const {
        const double b = 0.5 * time_step * time_step * c.inverse_mass;
        const double free = s0 + u * time_step;
        double force = attraction.mean(s0, free, c);
        for (int i = 0; i < iterations; ++i) force = attraction.mean(s0, free - b * force, c);
        return crossing_force(attraction, s0, free, b, c, force);
    }
};

/// The same equation by the secant method on  F -> F(s0, free - b F) - F,  for steps where the fixed point is slow: the
/// digits grow by half as much again with each of the `evaluations`, where the fixed point only adds to them.
template <int evaluations>
struct SecantImpulse {
    static constexpr bool half_step_positions = true;
    Attraction attraction;
    double time_step;

    RECOAT_HD double operator()(double s0, double u, const Coefficients& c) const {
        const double b = 0.5 * time_step * time_step * c.inverse_mass;
        const double free = s0 + u * time_step;
        const double strongest = c.attraction_gap > c.attraction_contact ? c.attraction_gap : c.attraction_contact;
        double before = attraction.mean(s0, free, c);
        double force = attraction.mean(s0, free - b * before, c);
        double change_before = force - before;
        RECOAT_UNROLL
        for (int i = 0; i < evaluations; ++i) {
            const double change = attraction.mean(s0, free - b * force, c) - force;
            const double slope = change - change_before;
            // A slope of nothing means that both are the root already; the plain fixed point is then as good.
            const double ratio = (force - before) / (slope != 0 ? slope : -1);
            const double step = slope != 0 ? -change * ratio : change;
            before = force;
            change_before = change;
            const double next = force + step;
            const double positive = next > 0 ? next : 0;
            force = positive < strongest ? positive : strongest;
        }
        return crossing_force(attraction, s0, free, b, c, force);
    }
};

/// The same equation by a bracketed secant (Illinois), for steps where the fixed point converges slowly or not at all.
struct BracketedImpulse {
    static constexpr bool half_step_positions = true;
    static constexpr int iterations = 14;
    Attraction attraction;
    double time_step;

    RECOAT_HD double operator()(double s0, double u, const Coefficients& c) const {
        const double b = 0.5 * time_step * time_step * c.inverse_mass;
        const double free = s0 + u * time_step;
        const double strongest = c.attraction_gap > c.attraction_contact ? c.attraction_gap : c.attraction_contact;
        double lower = free - b * strongest, upper = free;
        double below = lower - free + b * attraction.mean(s0, lower, c);
        double above = b * attraction.mean(s0, upper, c);
        double root = upper;
        int side = 0;
        for (int i = 0; i < iterations; ++i) {
            const double slope = above - below;
            root = slope > 0 ? (lower * above - upper * below) / slope : upper;
            const double value = root - free + b * attraction.mean(s0, root, c);
            const bool high = value > 0;
            upper = high ? root : upper;
            lower = high ? lower : root;
            // An end kept twice has its value halved, or the secant would creep.
            below = high ? (side == 1 ? 0.5 * below : below) : value;
            above = high ? value : (side == -1 ? 0.5 * above : above);
            side = high ? 1 : -1;
        }
        return crossing_force(attraction, s0, free, b, c, attraction.mean(s0, root, c));
    }
};

/// The plain explicit force at the separation of the step's start. Kept for comparison.
struct ExplicitImpulse {
    static constexpr bool half_step_positions = false;
    Attraction attraction;
    double time_step;

    RECOAT_HD double operator()(double s0, double, const Coefficients& c) const { return attraction.force(s0, c); }
};

/// The paper's prediction-correction [eq. 9] as read in docs/physics.md section 2.5: the predicted travel s0 -> s0 + u*
/// dt does its work, out of contact only; where the well cannot be left, the velocity is reflected. Kept for
/// comparison.
struct PredictionCorrectionImpulse {
    static constexpr bool half_step_positions = false;
    Attraction attraction;
    double time_step;

    RECOAT_HD double operator()(double s0, double u, const Coefficients& c) const {
        const double end = s0 + u * time_step;
        const double clipped = end > 0 ? end : 0;
        const double work = attraction.well(clipped, c) - attraction.well(s0 > 0 ? s0 : 0, c);
        const double square = u * u + 2 * work * c.inverse_mass;
        const double speed = std::sqrt(square > 0 ? square : 0);
        const double corrected = square > 0 ? (u < 0 ? -speed : speed) : -u;
        const double force = (u - corrected) / (c.inverse_mass * time_step);
        return s0 < 0 ? c.attraction_contact : (u != 0 ? force : 0);
    }
};

}  // namespace recoat
