#include "analyzer/fields/sphere_box.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace recoat {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double unit_ball_volume = 4 * pi / 3;

/// Ball in x > a for a >= 0: a cap.
double positive_cap(double a) { return pi / 3 * (1 - a) * (1 - a) * (2 + a); }

/// Ball in x > a, y > b for a, b >= 0: the general corner with the plane z = 0, twice. The plane through the centre
/// makes one arc a quarter less an angle, so that four arc tangents are left of six.
double positive_wedge(double a, double b) {
    const double rest = 1 - a * a - b * b;
    if (rest <= 0) return 0;
    const double s_ab = std::sqrt(rest), s_a = std::sqrt(1 - a * a), s_b = std::sqrt(1 - b * b);
    const double arc_a = std::atan2(s_ab, b), arc_b = std::atan2(s_ab, a);
    const double spherical = 2 * std::atan2(s_ab, a * b) - 2 * (a * arc_a + b * arc_b);
    const double plane_a = s_a * s_a * arc_a - b * s_ab;
    const double plane_b = s_b * s_b * arc_b - a * s_ab;
    return (spherical - a * plane_a - b * plane_b) / 3;
}

/// Area of a disc of squared radius `square` beyond the corner (b, c), with `arc` its arc and s_b, s_c the half chords
/// at the distances b and c.
double disc_corner(double square, double arc, double b, double c, double s_b, double s_c) {
    return 0.5 * (square * arc - b * (s_b - c) - c * (s_c - b));
}

/// Ball in x > a, y > b, z > c for a, b, c >= 0: a spherical triangle of three small circles over three plane corners.
double positive_corner(double a, double b, double c) {
    if (a * a + b * b + c * c >= 1) return 0;
    const double s_ab = std::sqrt(1 - a * a - b * b);
    const double s_bc = std::sqrt(1 - b * b - c * c);
    const double s_ca = std::sqrt(1 - c * c - a * a);
    const double arc_a = std::atan2(s_ab * s_ca - b * c, b * s_ca + c * s_ab);
    const double arc_b = std::atan2(s_bc * s_ab - c * a, c * s_ab + a * s_bc);
    const double arc_c = std::atan2(s_ca * s_bc - a * b, a * s_bc + b * s_ca);
    // Gauss-Bonnet: interior angles of the triangle - pi - total geodesic curvature of its sides.
    const double angles = std::atan2(s_ab, a * b) + std::atan2(s_bc, b * c) + std::atan2(s_ca, c * a);
    const double spherical = angles - pi - (a * arc_a + b * arc_b + c * arc_c);
    const double planes = a * disc_corner(1 - a * a, arc_a, b, c, s_ab, s_ca) +
                          b * disc_corner(1 - b * b, arc_b, c, a, s_bc, s_ab) +
                          c * disc_corner(1 - c * c, arc_c, a, b, s_ca, s_bc);
    return (spherical - planes) / 3;
}

bool is_free(double bound) { return bound <= -1; }

}  // namespace

double ball_corner(double a, double b, double c) {
    if (a >= 1 || b >= 1 || c >= 1) return 0;
    // A plane behind the centre: what is before it is the whole without what is beyond the mirrored plane.
    if (a < 0 && !is_free(a)) return ball_corner(-1, b, c) - ball_corner(-a, b, c);
    if (b < 0 && !is_free(b)) return ball_corner(a, -1, c) - ball_corner(a, -b, c);
    if (c < 0 && !is_free(c)) return ball_corner(a, b, -1) - ball_corner(a, b, -c);
    if (is_free(a)) {
        if (is_free(b)) return is_free(c) ? unit_ball_volume : positive_cap(c);
        return is_free(c) ? positive_cap(b) : positive_wedge(b, c);
    }
    if (is_free(b)) return is_free(c) ? positive_cap(a) : positive_wedge(c, a);
    return is_free(c) ? positive_wedge(a, b) : positive_corner(a, b, c);
}

double sphere_volume(double radius) { return unit_ball_volume * radius * radius * radius; }

double squared_distance_to_interval(double point, double lower, double upper) {
    const double distance = std::max({lower - point, point - upper, 0.0});
    return distance * distance;
}

double sphere_box_volume(Vec3 centre, double radius, Vec3 lower, Vec3 upper) {
    const double gap = squared_distance_to_interval(centre.x, lower.x, upper.x) +
                       squared_distance_to_interval(centre.y, lower.y, upper.y) +
                       squared_distance_to_interval(centre.z, lower.z, upper.z);
    if (gap >= radius * radius) return 0;
    const double x[2] = {(lower.x - centre.x) / radius, (upper.x - centre.x) / radius};
    const double y[2] = {(lower.y - centre.y) / radius, (upper.y - centre.y) / radius};
    const double z[2] = {(lower.z - centre.z) / radius, (upper.z - centre.z) / radius};
    const auto above = [&](double a, double b) { return ball_corner(a, b, z[0]) - ball_corner(a, b, z[1]); };
    const double share = (above(x[0], y[0]) - above(x[1], y[0])) - (above(x[0], y[1]) - above(x[1], y[1]));
    return std::max(share, 0.0) * radius * radius * radius;
}

}  // namespace recoat
