#pragma once

#include <cmath>

#include "common/host_device.hpp"
#include "solver/contact/coefficients.hpp"

namespace recoat {

/// van der Waals attraction between spheres, or sphere and wall, cut off at both ends [paper eq. 6]; in contact it is
/// that of the reduced Hamaker constant [paper eq. 7; docs/physics.md sections 2.3, 2.4].
///
///   F(s) = F_r (s < 0),  F_o (0 <= s < s_min),  F_o s_min^2 / s^2 (s_min <= s <= s_max),  0 beyond       [N]
struct Attraction {
    double minimum_separation = 0;  ///< s_min [m]
    double cut_off = 0;             ///< s_max [m]

    RECOAT_HD double force(double s, const Coefficients& c) const {
        // Flat selects only: nested ones keep the compiler from making vectors.
        const double strength = s < 0 ? c.attraction_contact : c.attraction_gap;
        const double ratio = minimum_separation / larger(s, minimum_separation);
        const double within = s <= cut_off ? 1 : 0;
        return within * strength * ratio * ratio;
    }

    /// G(s): work of the attraction between s and s_max, the depth of the well [J].
    RECOAT_HD double well(double s, const Coefficients& c) const {
        const double strength = c.attraction_gap * minimum_separation * minimum_separation;
        const double far = clamp(s, minimum_separation, cut_off);
        const double gap = clamp(s, 0, minimum_separation);
        const double overlap = larger(-s, 0);
        return strength * (1 / far - 1 / cut_off) + c.attraction_gap * (minimum_separation - gap) +
               c.attraction_contact * overlap;
    }

    /// Mean attraction over the path from s0 to s1: (G(s1) - G(s0)) / (s0 - s1) without its cancellation
    /// [docs/physics.md section 2.4].
    RECOAT_HD double mean(double s0, double s1, const Coefficients& c) const {
        const double contact = smaller(s1, 0) - smaller(s0, 0);
        const double gap = clamp(s1, 0, minimum_separation) - clamp(s0, 0, minimum_separation);
        const double far0 = clamp(s0, minimum_separation, cut_off), far1 = clamp(s1, minimum_separation, cut_off);
        const double strength = c.attraction_gap * minimum_separation * minimum_separation;
        const double work =
            c.attraction_contact * contact + c.attraction_gap * gap + strength * (far1 - far0) / (far0 * far1);
        const double path = s1 - s0;
        const double local = force(0.5 * (s0 + s1), c);
        const double length = std::fabs(path);
        const double mean_force = work / (length < shortest_path ? 1 : path);
        return length < shortest_path ? local : mean_force;
    }

    static constexpr double shortest_path = 1e-18;  ///< below it the force at the middle stands for the mean [m]

private:
    static RECOAT_HD double smaller(double a, double b) { return a < b ? a : b; }
    static RECOAT_HD double larger(double a, double b) { return a < b ? b : a; }
    static RECOAT_HD double clamp(double x, double lower, double upper) { return smaller(larger(x, lower), upper); }
};

}  // namespace recoat
