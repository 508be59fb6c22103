#pragma once

#include "common/vec3.hpp"

namespace recoat {

/// Volume of the part of the unit ball in x > a, y > b, z > c, in closed form with an absolute error of about 1e-15.
///
/// A bound of -1 or less does not cut the ball. The volume of a corner region follows from the divergence theorem,
/// 3 V = sum(plane distance x plane area) + spherical area, the spherical area from the theorem of Gauss and Bonnet.
[[nodiscard]] double ball_corner(double a, double b, double c);

/// Volume common to a sphere and the box [lower, upper], in the cube of the unit of the arguments. Bounds may be
/// infinite.
[[nodiscard]] double sphere_box_volume(Vec3 centre, double radius, Vec3 lower, Vec3 upper);

/// Volume of a whole sphere.
[[nodiscard]] double sphere_volume(double radius);

/// Square of the distance from `point` to the interval [lower, upper] on a line; 0 inside.
[[nodiscard]] double squared_distance_to_interval(double point, double lower, double upper);

}  // namespace recoat
