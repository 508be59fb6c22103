#include "solver/scene/read_scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

#include <fmt/format.h>

#include "common/error.hpp"
#include "common/fingerprint.hpp"
#include "common/readable.hpp"
#include "solver/scene/initial_particles.hpp"
#include "solver/scene/particle_scene.hpp"
#include "solver/scene/read_model.hpp"
#include "solver/scene/scene_notes.hpp"
#include "solver/scene/spread_scene.hpp"
#include "solver/scene/time_step_limits.hpp"
#include "solver/scene/whole_steps.hpp"

namespace recoat {
namespace {

/// Every key that a scene of this kind may have at its top.
void refuse_unknown_keys(const Config& config, const std::string& kind) {
    constexpr std::array<std::string_view, 14> common = {
        "precision", "sleep",   "scene",           "seed",       "time_step", "gravity",  "stages",
        "material",  "contact", "stiffness_ratio", "start_from", "output",    "cohesion", "pair_lists"};
    constexpr std::array<std::string_view, 3> spread = {"powder", "box", "blade"};
    constexpr std::array<std::string_view, 5> particles = {"particles", "walls", "duration", "y_period",
                                                           "reference_speed"};
    std::vector<std::string_view> keys(common.begin(), common.end());
    if (kind == "spread") keys.insert(keys.end(), spread.begin(), spread.end());
    if (kind == "particles") keys.insert(keys.end(), particles.begin(), particles.end());
    config.allow_only(keys);
}

std::int64_t steps_or_none(const Config& section, std::string_view key, double fallback, double time_step) {
    const double interval = section.quantity_or(key, Dimension::time, fallback, Range::not_negative());
    if (interval == 0) return 0;
    return std::max<std::int64_t>(1, whole_steps(interval, time_step));
}

void read_output(const Config& output, Scene& scene) {
    scene.output.trajectory_interval = steps_or_none(output, "trajectory_interval", 0, scene.time_step);
    scene.output.energy_interval = steps_or_none(output, "energy_interval", 1e-3, scene.time_step);
    scene.output.checkpoint_interval =
        output.quantity_or("checkpoint_interval", Dimension::time, 600, Range::positive());
}

/// A comment that changes with the content of a file that the scene reads, so that a run with other particles is not
/// taken for the same one.
std::string fingerprint(const std::filesystem::path& file) {
    if (!std::ifstream(file))
        throw InputError(file.string() + ": the file of the particles cannot be opened; check the path");
    return fmt::format("# content of {}: {:016x}\n", file.filename().string(), fingerprint_of(file));
}

void refuse_unstable_step(const Config& config, const Scene& scene) {
    for (const StepLimit& limit : time_step_limits(scene)) {
        if (limit.stability && scene.time_step >= limit.limit) {
            config.fail("time_step", "the step is longer than the stability limit \"" + limit.name + "\" (" +
                                         limit.formula + " = " + readable(limit.limit, "s") +
                                         "); choose a shorter step (recoat-solve check prints every limit)");
        }
    }
}

std::optional<DiameterBounds> diameters_of(const ParticleTable& particles) {
    if (particles.size() == 0) return {};
    return DiameterBounds{2 * std::ranges::min(particles.radius), 2 * std::ranges::max(particles.radius)};
}

}  // namespace

Scene read_scene(Config config, const std::filesystem::path& folder, std::optional<DiameterBounds> diameters) {
    constexpr std::array<std::string_view, 2> kinds = {"spread", "particles"};
    Scene scene;
    scene.kind = config.choice("scene", kinds);
    refuse_unknown_keys(config, scene.kind);
    read_model(config, scene);
    if (diameters) {
        scene.smallest_diameter = diameters->smallest;
        scene.largest_diameter = diameters->largest;
    }
    constexpr std::array<std::string_view, 2> precisions = {"mixed", "double"};
    scene.precision = config.choice_or("precision", precisions, precisions.front()) == "mixed"
                          ? Precision::mixed
                          : Precision::double_precision;
    scene.seed = config.integer_or("seed", 1, Range::not_negative());
    if (scene.kind == "spread") {
        read_spread_scene(config, folder, scene);
    } else {
        read_particle_scene(config, folder, scene);
    }
    read_output(config.section_or_empty("output"), scene);
    config.finish();
    refuse_unstable_step(config, scene);
    scene.resolved = config.resolved();
    return scene;
}

Scene load_scene(const std::filesystem::path& file, std::span<const std::string> overrides) {
    Scene scene = read_scene(Config::load(file, overrides), file.parent_path());
    // Sizes that stand in another file are known only now; the step must do for the smallest. Whoever takes the
    // particles themselves shows the warnings.
    if (!std::holds_alternative<ColumnSource>(scene.source)) {
        const auto diameters = diameters_of(initial_particles(scene, FileWarnings::leave_out));
        scene = read_scene(Config::load(file, overrides), file.parent_path(), diameters);
    }
    scene.notes = scene_notes(scene);
    if (const auto* table = std::get_if<TableSource>(&scene.source)) scene.resolved += fingerprint(table->file);
    if (const auto* state = std::get_if<StateSource>(&scene.source)) scene.resolved += fingerprint(state->file);
    return scene;
}

EngineSetup engine_setup(const Scene& scene, const Resources& resources) {
    EngineSetup setup;
    setup.model = scene.model;
    setup.gravity = {0, 0, -scene.gravity};
    setup.time_step = scene.time_step;
    setup.skins = scene.skins;
    setup.precision = scene.precision;
    setup.sleep = scene.sleep;
    setup.diameter = scene.diameter;
    setup.y_min = 0;
    setup.y_period = scene.y_period;
    setup.domain_lower = scene.domain_lower;
    setup.domain_upper = scene.domain_upper;
    setup.resources = resources;
    return setup;
}

}  // namespace recoat
