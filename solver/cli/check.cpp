#include "solver/cli/check.hpp"

#include <cmath>
#include <optional>

#include <nlohmann/json.hpp>

#include "common/version.hpp"
#include "solver/cli/calibration.hpp"
#include "solver/cli/check_text.hpp"
#include "solver/output/output_size.hpp"
#include "solver/scene/derived.hpp"
#include "solver/scene/initial_particles.hpp"
#include "solver/scene/step_errors.hpp"
#include "solver/scene/time_step_limits.hpp"
#include "solver/start_overlaps.hpp"

namespace recoat {
namespace {

using Json = nlohmann::ordered_json;

Json finite_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

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

std::string name_of(TimeStepChoice choice) {
    if (choice == TimeStepChoice::given) return "given";
    return choice == TimeStepChoice::automatic ? "auto" : "fast";
}

Json errors_json(const StepErrors& errors) {
    return {{"capture_velocity", errors.capture_velocity},
            {"rebound", errors.rebound},
            {"energy_balance", errors.energy_balance}};
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

/// Steps of all stages: at most, and those that are made in any case, while walls move or time is given.
struct Steps {
    std::int64_t most = 0, fixed = 0;

    explicit Steps(const Scene& scene) {
        for (const Stage& stage : scene.stages) {
            most += stage.steps();
            for (const Segment& segment : stage.segments) fixed += segment.rest ? 0 : segment.steps;
        }
    }
};

Json expectation_json(const Scene& scene, std::int64_t particles, const Resources& resources,
                      const Calibration& measured) {
    const Steps steps(scene);
    const double rate = measured.particle_steps_per_second / static_cast<double>(particles);
    return {{"backend", name_of(resources.backend)},
            {"threads", resources.threads},
            {"measured_particles", measured.particles},
            {"particle_steps_per_second", measured.particle_steps_per_second},
            {"processor_share", measured.processor_share},
            {"busy", measured.busy()},
            {"seconds_without_settling", finite_or_null(static_cast<double>(steps.fixed) / rate)},
            {"seconds", finite_or_null(static_cast<double>(steps.most) / rate)},
            {"bytes", measured.bytes_per_particle * static_cast<double>(particles)}};
}

Json output_json(const OutputSize& size, const std::filesystem::path& folder) {
    return {{"bytes", size.left()},
            {"bytes_meanwhile", size.most()},
            {"trajectory_bytes", size.trajectory()},
            {"trajectory_states", size.frames},
            {"state_bytes", size.frame},
            {"free_bytes", finite_or_null(free_bytes(folder))}};
}

/// The particles that the run would start with, tried out: a table that no engine takes is refused here, too.
std::vector<std::string> start_notes(const Scene& scene, const Resources& resources, const ParticleTable& particles,
                                     const EngineFactory& factory) {
    if (std::holds_alternative<ColumnSource>(scene.source)) return {};  // placed apart
    const auto engine = factory.make(engine_setup(scene, resources), particles, scene.walls);
    std::string note = start_overlaps(scene, *engine);
    return note.empty() ? std::vector<std::string>{} : std::vector{std::move(note)};
}

Json report_json(const Scene& scene, const Resources& resources, const std::filesystem::path& folder,
                 const EngineFactory& factory) {
    const auto* column = std::get_if<ColumnSource>(&scene.source);
    const ParticleTable start = column ? ParticleTable{} : initial_particles(scene);
    const std::int64_t particles = column ? column->count : static_cast<std::int64_t>(start.size());
    std::vector<std::string> notes = scene.notes;
    for (std::string& note : start_notes(scene, resources, start, factory)) notes.push_back(std::move(note));
    Json report = {{"version", program_version()},
                   {"scene", scene.kind},
                   {"particles", particles},
                   {"diameter", scene.diameter},
                   {"stiffness_ratio", scene.model.stiffness_ratio}};
    if (const std::optional<PowderSizes> sizes = powder_sizes(scene)) report["sizes"] = sizes_json(*sizes);
    report.update(derived_json(scene));
    report["reference_speed"] = scene.reference_speed;
    report["time_step"] = scene.time_step;
    report["time_step_choice"] = name_of(scene.time_step_choice);
    if (const std::optional<StepErrors> errors = step_errors(scene)) report["time_step_errors"] = errors_json(*errors);
    report["time_step_limits"] = limits_json(scene);
    report["stages"] = stages_json(scene);
    report["steps"] = Steps(scene).most;
    const Calibration measured = calibrate(scene, particles, resources, factory);
    report["expected"] = expectation_json(scene, particles, resources, measured);
    const OutputSize size =
        output_size(scene, particles, measured.checkpoint_bytes_per_particle * static_cast<double>(particles));
    report["expected"]["output"] = output_json(size, folder);
    if (std::string note = space_note(size, folder); !note.empty()) notes.push_back(std::move(note));
    report["notes"] = notes;
    return report;
}

}  // namespace

std::string check_report(const Scene& scene, const Resources& resources, const std::filesystem::path& folder, bool json,
                         const EngineFactory& factory) {
    const Json report = report_json(scene, resources, folder, factory);
    return json ? report.dump(2) + "\n" : check_text(report);
}

}  // namespace recoat
