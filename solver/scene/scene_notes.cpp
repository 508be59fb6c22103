#include "solver/scene/scene_notes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "common/readable.hpp"
#include "solver/contact/material.hpp"
#include "solver/engine/limits.hpp"
#include "solver/scene/time_step_limits.hpp"

namespace recoat {
namespace {

/// Beyond, a contact is no longer the small flat that Hertz' law is made for [docs/physics.md section 1.3].
constexpr double much_overlap = 0.05;

/// Force on a sphere at the bottom of the column that is filled in [N]; 0 where there is none.
double weight_above(const Scene& scene) {
    const auto* column = std::get_if<ColumnSource>(&scene.source);
    if (!column) return 0;
    const double mean_cube =
        column->sizes ? column->sizes->moment(3) : scene.diameter * scene.diameter * scene.diameter;
    const double mass = static_cast<double>(column->count) * std::numbers::pi / 6 * mean_cube * scene.model.density;
    const double area = (column->x_upper - column->x_lower) * scene.y_period;
    return mass * scene.gravity / area * scene.smallest_diameter * scene.smallest_diameter;
}

/// Overlap at which Hertz' force of two smallest spheres is `force` [m].
double overlap_under(const Scene& scene, double force) {
    const ContactModel& model = scene.model;
    const EffectiveModuli moduli = pair_moduli(model.youngs_modulus * model.stiffness_ratio, model.poisson_ratio);
    const double reduced_radius = 0.25 * scene.smallest_diameter;
    return std::pow(force / (4.0 / 3.0 * moduli.normal * std::sqrt(reduced_radius)), 2.0 / 3);
}

std::string softness(const Scene& scene) {
    const double overlap = expected_overlap(scene);
    if (overlap <= much_overlap) return {};
    const bool stops = overlap > limits::overlap;
    return fmt::format(
        "the spheres are too soft: with a young_modulus of {} and a stiffness_ratio of {:g} they would overlap by about "
        "{:.2g} of their radius ({}); give a larger {}",
        readable(scene.model.youngs_modulus, "Pa"), scene.model.stiffness_ratio, overlap,
        stops ? fmt::format("the run stops at {:g}", limits::overlap)
              : fmt::format("the contact law holds to about {:g}", much_overlap),
        scene.model.stiffness_ratio < 1 ? "stiffness_ratio" : "young_modulus");
}

std::string clearance(const Scene& scene) {
    if (!scene.spread) return {};
    const double gap = scene.spread->clearance;
    if (gap >= scene.largest_diameter) return {};
    if (gap < scene.smallest_diameter)
        return fmt::format(
            "no particle passes under the blade: blade.clearance is {}, the smallest particles measure {}; give a larger "
            "clearance for a layer",
            readable(gap, "m"), readable(scene.smallest_diameter, "m"));
    return fmt::format(
        "the largest particles do not pass under the blade: blade.clearance is {}, they measure up to {}",
        readable(gap, "m"), readable(scene.largest_diameter, "m"));
}

std::string sizes(const Scene& scene) {
    constexpr double wide = 4, beside = 1.5;
    const double d = scene.diameter, smallest = scene.smallest_diameter, largest = scene.largest_diameter;
    const bool far = largest > wide * d || smallest < d / wide || smallest > beside * d || largest < d / beside;
    if (!far) return {};
    const std::string measure = largest > smallest * (1 + 1e-12)
                                    ? fmt::format("{} to {}", readable(smallest, "m"), readable(largest, "m"))
                                    : readable(smallest, "m");
    return fmt::format(
        "the particles measure {}, far from material.diameter ({}), which is the unit dp and the sphere of the Bond "
        "number; check the units of the sizes, or give the diameter of a typical particle",
        measure, readable(d, "m"));
}

}  // namespace

double expected_overlap(const Scene& scene) {
    const ContactModel& model = scene.model;
    const double radius = 0.5 * scene.smallest_diameter;
    const double attraction = attraction_scaling(model.stiffness_ratio) *
                              pull_off_force(model.hamaker, 0.5 * radius, model.minimum_separation);
    return std::max(largest_impact_overlap(scene, scene.reference_speed),
                    overlap_under(scene, attraction + weight_above(scene))) /
           radius;
}

std::vector<std::string> scene_notes(const Scene& scene) {
    std::vector<std::string> notes;
    for (std::string note : {softness(scene), clearance(scene), sizes(scene)}) {
        if (!note.empty()) notes.push_back(std::move(note));
    }
    return notes;
}

}  // namespace recoat
