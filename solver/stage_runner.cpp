#include "solver/stage_runner.hpp"

#include <algorithm>
#include <stdexcept>

#include "common/error.hpp"
#include "common/version.hpp"
#include "solver/output/checkpoint.hpp"
#include "solver/output/packing_density.hpp"
#include "solver/output/state_of_engine.hpp"
#include "solver/run_ending.hpp"
#include "solver/run_files.hpp"
#include "solver/stop_request.hpp"

namespace recoat {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Steps until the next multiple of `interval`.
std::int64_t until_multiple(std::int64_t step, std::int64_t interval) { return interval - step % interval; }

DrawnSpace drawn_space(const Scene& scene) {
    DrawnSpace space{scene.domain_lower, scene.domain_upper};
    if (scene.y_period > 0) {
        space.lower.y = 0;
        space.upper.y = scene.y_period;
    }
    return space;
}

}  // namespace

StageRunner::StageRunner(const Scene& scene, const RunOptions& options, Engine& engine, RunProgress progress)
    : scene_(scene),
      options_(options),
      engine_(engine),
      progress_(std::move(progress)),
      trajectory_(options.folder),
      particles_(engine.particles().size()),
      line_(options.quiet, particles_, options.name),
      energy_watch_(scene, progress_.start, engine.particles()),
      counted_(Clock::now()),
      saved_(Clock::now()) {}

int StageRunner::run() {
    if (engine_.step() == 0 && progress_.energy.empty() && progress_.frames.empty()) sample();
    remake_last_state();
    while (progress_.stage < scene_.stages.size()) {
        if (must_stop() || !run_stage(scene_.stages[progress_.stage])) return stop();
    }
    finish_run();
    return 0;
}

void StageRunner::write_stage(const Stage& stage) const {
    StateInfo info = state_info(scene_, stage.name, options_.resources.backend);
    if (!progress_.blade_stop.x.empty())
        info.layer_end = layer_end(progress_.blade_stop, engine_.particles(), scene_.diameter);
    write_state(options_.folder / (stage.name + ".vtkhdf"), info, state_of_engine(engine_, scene_.y_period));
}

/// Where it was deleted, and the engine is still where the stage ended.
void StageRunner::remake_last_state() {
    if (!missing_files(scene_, options_.folder, progress_).last_state) return;
    const Stage& stage = scene_.stages[progress_.stage - 1];
    write_stage(stage);
    if (progress_.stage < scene_.stages.size())
        line_.say(stage.name + ".vtkhdf was gone; it is made again from the checkpoint.");
}

bool StageRunner::run_stage(const Stage& stage) {
    std::int64_t later = 0;
    for (std::size_t k = progress_.stage + 1; k < scene_.stages.size(); ++k) later += scene_.stages[k].steps();
    line_.begin({stage.name, stage_steps(), stage.steps(), later});
    while (progress_.segment < stage.segments.size()) {
        if (!run_segment(stage.segments[progress_.segment])) return false;
    }
    finish_stage(stage);
    return true;
}

bool StageRunner::run_segment(const Segment& segment) {
    if (!progress_.segment_entered) enter(segment);
    while (progress_.segment_steps < segment.steps && !at_rest(segment)) {
        if (must_stop()) return false;
        const std::int64_t steps = chunk(segment);
        advance(steps);
        progress_.segment_steps += steps;
        sample();
        watch();
        check_rest(segment);
        line_.update(stage_steps());
        save_if_due();
    }
    leave(segment);
    return true;
}

void StageRunner::enter(const Segment& segment) {
    for (const std::string& name : segment.removed) engine_.remove_wall(wall_index(name));
    for (const WallMotion& motion : segment.motions)
        engine_.set_wall_velocity(wall_index(motion.wall), motion.velocity);
    progress_.segment_entered = true;
}

void StageRunner::leave(const Segment& segment) {
    for (const WallMotion& motion : segment.motions) {
        engine_.set_wall_velocity(wall_index(motion.wall), {});
        if (scene_.stages[progress_.stage].kind == "spread" && motion.velocity.x > 0) keep_blade_stop(motion.wall);
    }
    progress_.settled = at_rest(segment);
    ++progress_.segment;
    progress_.segment_entered = false;
    progress_.segment_steps = 0;
    progress_.checks_at_rest = 0;
}

void StageRunner::keep_blade_stop(const std::string& blade) {
    progress_.blade_stop.rear = engine_.walls()[wall_index(blade)].lower.x;
    progress_.blade_stop.x.clear();
    for (const Vec3& position : engine_.particles().position) progress_.blade_stop.x.push_back(position.x);
}

std::size_t StageRunner::wall_index(const std::string& name) const {
    const std::vector<Wall>& walls = engine_.walls();
    for (std::size_t i = 0; i < walls.size(); ++i) {
        if (walls[i].name == name) return i;
    }
    throw std::logic_error("no wall " + name);
}

/// Steps to the next moment at which something is looked at or written.
std::int64_t StageRunner::chunk(const Segment& segment) const {
    std::int64_t steps = std::min(segment.steps - progress_.segment_steps, chunk_limit_);
    if (segment.rest) steps = std::min(steps, until_multiple(progress_.segment_steps, segment.rest->interval));
    for (std::int64_t interval :
         {scene_.output.trajectory_interval, scene_.output.energy_interval, EnergyWatch::interval}) {
        if (interval > 0) steps = std::min(steps, until_multiple(engine_.step(), interval));
    }
    if (options_.until_step) steps = std::min(steps, *options_.until_step - engine_.step());
    return steps;
}

void StageRunner::advance(std::int64_t steps) {
    const Clock::time_point start = Clock::now();
    try {
        engine_.advance(steps);
    } catch (const SimulationFault& error) {
        fault(error);
    }
    const double seconds = seconds_since(start);
    if (steps == chunk_limit_ && seconds < 0.15) chunk_limit_ *= 2;
    if (seconds > 0.5) chunk_limit_ = std::max<std::int64_t>(1, chunk_limit_ / 2);
}

void StageRunner::fault(const SimulationFault& error) {
    const std::filesystem::path file = options_.folder / "fault.vtkhdf";
    const std::size_t stage = std::min(progress_.stage, scene_.stages.size() - 1);
    line_.say(scene_.stages[stage].name + ": fault at step " + std::to_string(engine_.step()) + ".");
    try {
        write_state(file, state_info(scene_, scene_.stages[stage].name, options_.resources.backend),
                    state_of_engine(engine_, scene_.y_period));
    } catch (const InputError& problem) {
        throw SimulationFault(std::string(error.what()) +
                              ". The state of the moment before is lost: " + problem.what());
    }
    throw SimulationFault(std::string(error.what()) + ". The state of the moment before is in " + file.string() + ".");
}

void StageRunner::sample() {
    const std::int64_t step = engine_.step();
    const OutputPlan& plan = scene_.output;
    if (plan.energy_interval > 0 && step % plan.energy_interval == 0) progress_.energy.add(engine_);
    if (plan.trajectory_interval > 0 && step % plan.trajectory_interval == 0) {
        const std::string& stage = scene_.stages[progress_.stage].name;
        progress_.frames.push_back(trajectory_.add(progress_.frames.size(),
                                                   state_info(scene_, stage, options_.resources.backend),
                                                   state_of_engine(engine_, scene_.y_period)));
        progress_.walls.add(engine_);
    }
}

/// At steps that depend on the scene only, so that every run of it ends alike.
void StageRunner::watch() {
    const std::int64_t step = engine_.step(), energy = scene_.output.energy_interval;
    const bool last = progress_.segment_steps == scene_.stages[progress_.stage].segments[progress_.segment].steps;
    if (step % EnergyWatch::interval != 0 && !(energy > 0 && step % energy == 0) && !last) return;
    try {
        energy_watch_.check(engine_);
    } catch (const SimulationFault& error) {
        fault(error);
    }
}

void StageRunner::check_rest(const Segment& segment) {
    if (!segment.rest || progress_.segment_steps % segment.rest->interval != 0) return;
    const std::int64_t stragglers = segment.rest->stragglers.value_or(RestCriterion::stragglers_among(particles_));
    RestLimit limit{segment.rest->energy * static_cast<double>(particles_), static_cast<std::size_t>(stragglers)};
    // Who rolls away ahead of the blade leaves the layer as it is.
    if (scene_.stages[progress_.stage].kind == "spread") limit.front = engine_.walls()[wall_index("blade")].upper.x;
    progress_.checks_at_rest = engine_.at_rest(limit) ? progress_.checks_at_rest + 1 : 0;
}

bool StageRunner::must_stop() const {
    return stop_signal() != 0 || (options_.until_step && engine_.step() >= *options_.until_step);
}

int StageRunner::stop() {
    save_checkpoint();
    summarise(RunStatus::stopped);
    line_.say("Stopped at step " + std::to_string(engine_.step()) + "; continue with: recoat-solve resume " +
              quoted(options_.folder));
    return stop_signal() != 0 ? 128 + stop_signal() : 0;
}

void StageRunner::finish_stage(const Stage& stage) {
    count_time();
    StageRecord record;
    record.name = stage.name;
    record.steps = stage_steps();
    record.time = static_cast<double>(record.steps) * scene_.time_step;
    record.settled = progress_.settled;
    record.wall_seconds = progress_.stage_wall_seconds;
    record.kinetic_energy = engine_.kinetic_energy();
    record.largest_overlap = engine_.largest_overlap();
    record.start = progress_.finished.empty() ? progress_.start : progress_.finished.back().end;
    record.end = engine_.ledger();
    if (stage.kind == "fill") {
        const double area = scene_.spread->fill_length * scene_.y_period;
        record.packing_density = bed_packing_density(engine_.particles(), area);
    }
    if (!progress_.blade_stop.x.empty())
        record.layer_end = layer_end(progress_.blade_stop, engine_.particles(), scene_.diameter);
    write_stage(stage);
    progress_.walls.add(engine_);
    line_.say(stage_ending(stage, record));
    progress_.finished.push_back(record);
    progress_.stage_first_step = engine_.step();
    progress_.stage_wall_seconds = 0;
    progress_.settled = false;
    progress_.segment = 0;
    ++progress_.stage;
    save_checkpoint();
}

void StageRunner::finish_run() {
    const std::string& last = scene_.stages.back().name;
    if (!progress_.frames.empty())
        trajectory_.assemble(progress_.frames, state_info(scene_, last, options_.resources.backend));
    summarise(RunStatus::finished);
    line_.say(run_ending(scene_, progress_, options_.folder));
}

void StageRunner::count_time() {
    const double seconds = seconds_since(counted_);
    counted_ = Clock::now();
    progress_.wall_seconds += seconds;
    progress_.stage_wall_seconds += seconds;
}

void StageRunner::save_checkpoint() {
    count_time();
    write_checkpoint(options_.folder, {program_version(), scene_.resolved, progress_, engine_.save()});
    saved_ = Clock::now();
}

void StageRunner::save_if_due() {
    if (seconds_since(saved_) >= scene_.output.checkpoint_interval) save_checkpoint();
}

void StageRunner::summarise(RunStatus status) {
    if (!progress_.energy.empty()) progress_.energy.write_csv(options_.folder / "energy.csv");
    if (!progress_.walls.empty()) {
        progress_.walls.write(options_.folder / "walls.vtkhdf", drawn_space(scene_), scene_.diameter);
    }
    write_summary(options_.folder / "summary.json", scene_, progress_, engine_, status, options_.resources);
}

}  // namespace recoat
