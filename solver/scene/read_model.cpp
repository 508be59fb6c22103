#include "solver/scene/read_model.hpp"

#include "solver/contact/material.hpp"
#include "solver/engine/limits.hpp"
#include "solver/scene/model_options.hpp"

namespace recoat {
namespace {

template <class Value>
Value read_option(const Config& config, std::string_view section, std::string_view key) {
    return static_cast<Value>(model_option(section, key).read(config));
}

bool read_switch(const Config& config, std::string_view section, std::string_view key) {
    const ModelOption& option = model_option(section, key);
    return option.values[option.read(config)].name == "true";
}

void read_material(Config& config, Scene& scene) {
    const Config material = config.section("material");
    scene.diameter = material.quantity("diameter", Dimension::length, Range::positive());
    scene.smallest_diameter = scene.largest_diameter = scene.diameter;
    scene.model.density = material.quantity("density", Dimension::density, Range::positive());
    scene.model.youngs_modulus = material.quantity("young_modulus", Dimension::pressure, Range::positive());
    scene.model.poisson_ratio = material.number("poisson_ratio", {.lower = 0, .upper = 0.5});
    material.finish();
    config.set_particle_diameter(scene.diameter);
}

void read_contact(const Config& contact, ContactModel& model) {
    model.restitution = contact.number("restitution", {.lower = 0, .upper = 1, .lower_open = true});
    model.sliding_friction = contact.number("sliding_friction", Range::not_negative());
    model.rolling_friction = contact.number("rolling_friction", Range::not_negative());
    model.wall_modulus = read_option<WallModulus>(contact, "contact", "wall_modulus");
    model.rolling_length = read_option<RollingLength>(contact, "contact", "rolling_length");
    model.rolling_form = read_option<RollingForm>(contact, "contact", "rolling_form");
    model.lever_arm = read_option<LeverArm>(contact, "contact", "lever_arm");
    model.tangential_damping = read_option<TangentialDamping>(contact, "contact", "tangential_damping");
    model.cap_dashpot = read_switch(contact, "contact", "dashpot_cap");
    model.clip_normal = read_switch(contact, "contact", "normal_clip");
    contact.finish();
}

void read_strength(const Config& cohesion, Scene& scene) {
    ContactModel& model = scene.model;
    const double radius = 0.5 * scene.diameter;
    if (cohesion.has("bond_number") && cohesion.has("hamaker")) {
        cohesion.fail("hamaker", "the strength is given twice; give either bond_number or hamaker");
    }
    if (cohesion.has("hamaker")) {
        model.hamaker = cohesion.quantity("hamaker", Dimension::energy, Range::not_negative());
        scene.bond_number =
            bond_from_hamaker(model.hamaker, radius, model.density, scene.reference_gravity, model.minimum_separation);
    } else {
        scene.bond_number = cohesion.number("bond_number", Range::not_negative());
        model.hamaker = hamaker_from_bond(scene.bond_number, radius, model.density, scene.reference_gravity,
                                          model.minimum_separation);
    }
}

void read_cohesion(const Config& cohesion, Scene& scene) {
    ContactModel& model = scene.model;
    model.minimum_separation =
        cohesion.quantity_or("minimum_separation", Dimension::length, model.minimum_separation, Range::positive());
    model.cut_off = cohesion.quantity_or("cut_off", Dimension::length, model.cut_off, Range::positive());
    model.scheme = read_option<CohesionScheme>(cohesion, "cohesion", "scheme");
    model.non_contact = read_option<NonContactHamaker>(cohesion, "cohesion", "non_contact_hamaker");
    read_strength(cohesion, scene);
    cohesion.finish();
    if (model.cut_off <= model.minimum_separation) {
        cohesion.fail("cut_off", "the attraction ends before minimum_separation; give a longer cut_off, e.g. 100 nm");
    }
    if (model.cut_off > 0.1 * scene.diameter) {
        cohesion.fail("cut_off", "the attraction reaches further than 0.1 dp; give a shorter cut_off, e.g. 100 nm");
    }
}

void read_skins(const Config& lists, Scene& scene) {
    const double diameter = scene.diameter;
    const Range skins{.lower = 1.5 * limits::most_margin * diameter, .upper = diameter};
    scene.skins.far = lists.quantity_or("skin", Dimension::length, scene.skins.far * diameter, skins) / diameter;
    scene.skins.close_steps = lists.number_or("close_steps", scene.skins.close_steps, {.lower = 1, .upper = 1e6});
}

}  // namespace

void read_model(Config& config, Scene& scene) {
    read_material(config, scene);
    read_contact(config.section("contact"), scene.model);
    scene.gravity = config.quantity("gravity", Dimension::acceleration, Range::not_negative());
    if (scene.gravity > 0) scene.reference_gravity = scene.gravity;
    scene.model.stiffness_ratio = config.number_or("stiffness_ratio", 1, {.lower = 0, .upper = 1, .lower_open = true});
    if (config.has("cohesion")) read_cohesion(config.section("cohesion"), scene);
    read_skins(config.section_or_empty("pair_lists"), scene);
    scene.sleep = config.boolean_or("sleep", scene.sleep);
}

}  // namespace recoat
