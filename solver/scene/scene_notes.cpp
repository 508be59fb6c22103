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

/// Volume of the powder that is filled in [m3]; 0 where it comes from a state.
double powder_volume(const Scene& scene) {
    const auto* column = std::get_if<ColumnSource>(&scene.source);
    if (!column) return 0;
    const double d = scene.diameter, mean_cube = column->sizes ? column->sizes->moment(3) : d * d * d;
    return static_cast<double>(column->count) * std::numbers::pi / 6 * mean_cube;
}

/// Force on a sphere at the bottom of the column that is filled in [N]; 0 where there is none.
double weight_above(const Scene& scene) {
    const auto* column = std::get_if<ColumnSource>(&scene.source);
    if (!column) return 0;
    const double area = (column->x_upper - column->x_lower) * scene.y_period;
    const double pressure = powder_volume(scene) * scene.model.density * scene.gravity / area;
    return pressure * scene.smallest_diameter * scene.smallest_diameter;
}

/// Overlap at which Hertz' force of two smallest spheres is `force` [m].
double overlap_under(const Scene& scene, double force) {
    const ContactModel& model = scene.model;
    const EffectiveModuli moduli = pair_moduli(model.youngs_modulus * model.stiffness_ratio, model.poisson_ratio);
    const double reduced_radius = 0.25 * scene.smallest_diameter;
    return std::pow(force / (4.0 / 3.0 * moduli.normal * std::sqrt(reduced_radius)), 2.0 / 3);
}

/// Of two smallest spheres [m], without damping.
struct Overlaps {
    double impact, rest;

    explicit Overlaps(const Scene& scene) : impact(largest_impact_overlap(scene, scene.reference_speed)) {
        const ContactModel& model = scene.model;
        const double attraction =
            attraction_scaling(model.stiffness_ratio) *
            pull_off_force(model.hamaker, 0.25 * scene.smallest_diameter, model.minimum_separation);
        rest = overlap_under(scene, attraction + weight_above(scene));
    }
};

std::string softness(const Scene& scene) {
    const double share = expected_overlap(scene);
    if (share <= much_overlap) return {};
    const Overlaps overlaps(scene);
    return fmt::format(
        "the spheres are too soft: with a young_modulus of {} and a stiffness_ratio of {:g} they would overlap by "
        "about "
        "{:.2g} of their radius ({}; {}); give a larger {}",
        readable(scene.model.youngs_modulus, "Pa"), scene.model.stiffness_ratio, share,
        overlaps.impact > overlaps.rest ? "when they meet at " + readable_speed(scene.reference_speed)
                                        : "under their attraction and the powder above",
        share > limits::overlap ? fmt::format("the run stops at {:g}", limits::overlap)
                                : fmt::format("the contact law holds to about {:g}", much_overlap),
        scene.model.stiffness_ratio < 1 ? "stiffness_ratio" : "young_modulus");
}

/// Denser than osmium, or stiffer than diamond: the unit is another one.
std::string material(const Scene& scene) {
    constexpr double densest = 23000, stiffest = 1.3e12;
    if (scene.model.density > densest)
        return fmt::format("material.density is {:g} kg/m3, more than that of any metal; check the unit",
                           scene.model.density);
    if (scene.model.youngs_modulus > stiffest)
        return fmt::format("material.young_modulus is {}, more than that of diamond; check the unit",
                           readable(scene.model.youngs_modulus, "Pa"));
    return {};
}

/// The heap is lower than the bed that it comes from.
std::string reach(const Scene& scene) {
    constexpr double loosest = 0.5;  ///< packing density of a bed that has settled
    if (!scene.spread || scene.spread->length == 0 || powder_volume(scene) == 0) return {};
    const double height = powder_volume(scene) / (loosest * scene.spread->fill_length * scene.y_period);
    if (scene.spread->clearance < height) return {};
    return fmt::format(
        "the blade passes above the powder: blade.clearance is {}, the bed that is filled in about {} high; give more "
        "powder.particles, or a shorter box.fill_length",
        readable(scene.spread->clearance, "m"), readable(height, "m"));
}

/// Rest is where particles move slower than they would after falling a small part of their diameter.
std::string rest(const Scene& scene) {
    constexpr double lively = 0.1;  ///< m g d_p
    const double unit =
        sphere_mass(0.5 * scene.diameter, scene.model.density) * scene.reference_gravity * scene.diameter;
    for (const Stage& stage : scene.stages) {
        for (const Segment& segment : stage.segments) {
            if (!segment.rest || segment.rest->energy <= lively * unit) continue;
            return fmt::format(
                "in the stage {} particles count as at rest while they still move at {}: its settle_energy is {:.3g} m "
                "g "
                "d_p; give 1e-4 or less",
                stage.name,
                readable_speed(std::sqrt(2 * segment.rest->energy / unit * scene.reference_gravity * scene.diameter)),
                segment.rest->energy / unit);
        }
    }
    return {};
}

std::string clearance(const Scene& scene) {
    if (!scene.spread) return {};
    const double gap = scene.spread->clearance;
    if (gap >= scene.largest_diameter) return {};
    if (gap < scene.smallest_diameter)
        return fmt::format(
            "no particle passes under the blade: blade.clearance is {}, the smallest particles measure {}; give a "
            "larger "
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
    const Overlaps overlaps(scene);
    return std::max(overlaps.impact, overlaps.rest) / (0.5 * scene.smallest_diameter);
}

std::vector<std::string> scene_notes(const Scene& scene) {
    std::vector<std::string> notes;
    for (std::string note :
         {material(scene), softness(scene), clearance(scene), reach(scene), rest(scene), sizes(scene)}) {
        if (!note.empty()) notes.push_back(std::move(note));
    }
    return notes;
}

}  // namespace recoat
