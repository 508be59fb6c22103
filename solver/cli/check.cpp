#include "solver/cli/check.hpp"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "common/state.hpp"
#include "common/version.hpp"
#include "solver/cli/calibration.hpp"
#include "solver/scene/derived.hpp"
#include "solver/scene/initial_particles.hpp"
#include "solver/scene/time_step_limits.hpp"

namespace recoat {
namespace {

using Json = nlohmann::ordered_json;

Json finite_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

std::int64_t count_particles(const Scene& scene) {
    if (const auto* column = std::get_if<ColumnSource>(&scene.source)) return column->count;
    return static_cast<std::int64_t>(initial_particles(scene).size());
}

Json moduli_json(const EffectiveModuli& original, const EffectiveModuli& reduced, double EffectiveModuli::*member) {
    return {{"original", original.*member}, {"reduced", reduced.*member}};
}

Json derived_json(const Scene& scene) {
    const DerivedNumbers n = derived_numbers(scene);
    return {{"mass", n.mass},
            {"inertia", n.inertia},
            {"weight", n.weight},
            {"effective_modulus",
             {{"pair", moduli_json(n.pair_original, n.pair_reduced, &EffectiveModuli::normal)},
              {"wall", moduli_json(n.wall_original, n.wall_reduced, &EffectiveModuli::normal)}}},
            {"effective_shear_modulus",
             {{"pair", moduli_json(n.pair_original, n.pair_reduced, &EffectiveModuli::shear)},
              {"wall", moduli_json(n.wall_original, n.wall_reduced, &EffectiveModuli::shear)}}},
            {"damping_coefficient", n.damping},
            {"hamaker", {{"original", n.hamaker_original}, {"reduced", n.hamaker_reduced}}},
            {"bond_number", {{"pair", n.bond_number.pair}, {"wall", n.bond_number.wall}}},
            {"pull_off_force", {{"pair", n.pull_off.pair}, {"wall", n.pull_off.wall}}},
            {"inertial_length",
             {{"paper", finite_or_null(n.inertial_length_paper)}, {"wall", finite_or_null(n.inertial_length_wall)}}}};
}

Json sizes_json(const PowderSizes& sizes) {
    return {{"smallest", sizes.smallest},
            {"largest", sizes.largest},
            {"mean", sizes.mean},
            {"sauter", sizes.sauter},
            {"median_by_number", sizes.median_by_number},
            {"median_by_mass", sizes.median_by_mass},
            {"bond_number", {{"smallest", sizes.bond_smallest}, {"largest", sizes.bond_largest}}}};
}

Json limits_json(const Scene& scene) {
    Json limits = Json::array();
    for (const StepLimit& limit : time_step_limits(scene)) {
        limits.push_back({{"name", limit.name},
                          {"formula", limit.formula},
                          {"limit", limit.limit},
                          {"share", scene.time_step / limit.limit},
                          {"stability", limit.stability}});
    }
    return limits;
}

Json stages_json(const Scene& scene) {
    Json stages = Json::array();
    for (const Stage& stage : scene.stages) {
        stages.push_back({{"name", stage.name},
                          {"kind", stage.kind},
                          {"steps", stage.steps()},
                          {"time", static_cast<double>(stage.steps()) * scene.time_step},
                          {"may_end_early", stage.may_end_early()}});
    }
    return stages;
}

Json expectation_json(const Scene& scene, std::int64_t particles, std::int64_t steps, const Resources& resources,
                      const EngineFactory& factory) {
    const Calibration measured = calibrate(scene, particles, resources, factory);
    const double work = static_cast<double>(particles) * static_cast<double>(steps);
    return {{"backend", name_of(resources.backend)},
            {"threads", resources.threads},
            {"measured_particles", measured.particles},
            {"particle_steps_per_second", measured.particle_steps_per_second},
            {"seconds", work / measured.particle_steps_per_second},
            {"bytes", measured.bytes_per_particle * static_cast<double>(particles)}};
}

Json report_json(const Scene& scene, const Resources& resources, const EngineFactory& factory) {
    const std::int64_t particles = count_particles(scene);
    std::int64_t steps = 0;
    for (const Stage& stage : scene.stages) steps += stage.steps();
    Json report = {{"version", program_version()},
                   {"scene", scene.kind},
                   {"particles", particles},
                   {"diameter", scene.diameter},
                   {"stiffness_ratio", scene.model.stiffness_ratio}};
    if (const std::optional<PowderSizes> sizes = powder_sizes(scene)) report["sizes"] = sizes_json(*sizes);
    report.update(derived_json(scene));
    report["reference_speed"] = scene.reference_speed;
    report["time_step"] = scene.time_step;
    report["time_step_is_automatic"] = scene.time_step_is_automatic;
    report["time_step_limits"] = limits_json(scene);
    report["stages"] = stages_json(scene);
    report["steps"] = steps;
    report["expected"] = expectation_json(scene, particles, steps, resources, factory);
    return report;
}

std::string number(const Json& value) {
    return value.is_null() ? "infinite" : fmt::format("{:.6g}", value.get<double>());
}

std::string row(const std::string& name, const Json& value, const std::string& unit) {
    return fmt::format("  {:<46} {:>14} {}\n", name, number(value), unit);
}

std::string material_text(const Json& r) {
    std::string text = "Particles\n" + row("number", r["particles"], "");
    text += row("diameter d_p", r["diameter"], "m") + row("mass m", r["mass"], "kg");
    text += row("moment of inertia I", r["inertia"], "kg m2") + row("weight m g", r["weight"], "N");
    text += "Stiffness\n" + row("stiffness ratio Y^R/Y^O", r["stiffness_ratio"], "");
    for (const char* partner : {"pair", "wall"}) {
        for (const char* form : {"original", "reduced"}) {
            const std::string what = fmt::format(" {}, {}", partner, form);
            text += row("E*" + what, r["effective_modulus"][partner][form], "Pa");
            text += row("G*" + what, r["effective_shear_modulus"][partner][form], "Pa");
        }
    }
    return text + row("damping coefficient beta", r["damping_coefficient"], "");
}

std::string sizes_text(const Json& r) {
    if (!r.contains("sizes")) return {};
    const Json& s = r["sizes"];
    std::string text =
        "Sizes (mass, weight, cohesion and inertial length below are those of a sphere of diameter d_p)\n";
    text += row("smallest diameter", s["smallest"], "m") + row("largest diameter", s["largest"], "m");
    text += row("mean diameter, by number", s["mean"], "m") + row("Sauter diameter d_32", s["sauter"], "m");
    text += row("median diameter, by number", s["median_by_number"], "m");
    text += row("median diameter, by mass", s["median_by_mass"], "m");
    text += row("Bond number, pair of the smallest", s["bond_number"]["smallest"], "");
    return text + row("Bond number, pair of the largest", s["bond_number"]["largest"], "");
}

std::string cohesion_text(const Json& r) {
    std::string text = "Cohesion\n" + row("Hamaker constant A^O (out of contact)", r["hamaker"]["original"], "J");
    text += row("Hamaker constant A^R (in contact)", r["hamaker"]["reduced"], "J");
    text +=
        row("Bond number, pair", r["bond_number"]["pair"], "") + row("Bond number, wall", r["bond_number"]["wall"], "");
    text += row("pull-off force, pair", r["pull_off_force"]["pair"], "N");
    text += row("pull-off force, wall", r["pull_off_force"]["wall"], "N");
    text += row("inertial length, pull-off force of the pair", r["inertial_length"]["paper"], "d_p");
    return text + row("inertial length, pull-off force of the wall", r["inertial_length"]["wall"], "d_p");
}

std::string time_text(const Json& r) {
    const std::string by = r["time_step_is_automatic"].get<bool>() ? "chosen (auto)" : "chosen";
    std::string text = "Time step\n" + row(by, r["time_step"], "s");
    for (const Json& limit : r["time_step_limits"]) {
        text +=
            fmt::format("  {:<46} {:>14} s   the step is {:.2f} % of it   {}{}\n", limit["name"].get<std::string>(),
                        number(limit["limit"]), 100 * limit["share"].get<double>(), limit["formula"].get<std::string>(),
                        limit["stability"].get<bool>() ? " (stability limit)" : "");
    }
    text += "Stages\n";
    for (const Json& stage : r["stages"]) {
        text += fmt::format("  {:<46} {:>14} steps, {:.6g} s{}\n", stage["name"].get<std::string>(),
                            stage["steps"].get<std::int64_t>(), stage["time"].get<double>(),
                            stage["may_end_early"].get<bool>() ? " at most" : "");
    }
    return text;
}

std::string expectation_text(const Json& r) {
    const Json& e = r["expected"];
    return "Expected\n" + row("steps at most", r["steps"], "") +
           row("rate on this machine, measured", e["particle_steps_per_second"],
               fmt::format("particle-steps/s (block of {} touching spheres, {} thread(s))",
                           e["measured_particles"].get<std::int64_t>(), e["threads"].get<int>())) +
           row("run time at most", Json(e["seconds"].get<double>() / 3600), "h") +
           row("memory of the particles", Json(e["bytes"].get<double>() / 1048576), "MiB");
}

}  // namespace

std::string check_report(const Scene& scene, const Resources& resources, bool json, const EngineFactory& factory) {
    const Json report = report_json(scene, resources, factory);
    if (json) return report.dump(2) + "\n";
    return sizes_text(report) + material_text(report) + cohesion_text(report) + time_text(report) +
           expectation_text(report);
}

}  // namespace recoat
