#include "solver/run.hpp"

#include <unistd.h>

#include "common/config.hpp"
#include "common/error.hpp"
#include "common/version.hpp"
#include "solver/output/checkpoint.hpp"
#include "solver/output/summary.hpp"
#include "solver/progress_line.hpp"
#include "solver/scene/initial_particles.hpp"
#include "solver/scene/read_scene.hpp"
#include "solver/stage_runner.hpp"

namespace recoat {
namespace {

namespace fs = std::filesystem;

/// What to do with a folder.
enum class Plan { start, resume, nothing };

void refuse_other_scene(const std::string& config, const Scene& scene, const fs::path& folder) {
    if (config == scene.resolved) return;
    throw InputError(
        folder.string() +
        ": the folder holds a run of another configuration; choose another folder for --out, or replace it "
        "with --overwrite");
}

/// Whether every file of a finished run is in place.
bool complete(const Scene& scene, const fs::path& folder) {
    for (const Stage& stage : scene.stages) {
        if (!fs::exists(folder / (stage.name + ".vtkhdf"))) return false;
    }
    return scene.output.trajectory_interval == 0 || fs::exists(folder / "trajectory.vtkhdf");
}

/// `overwrite` replaces a run of another configuration, and a finished one of another version, instead of refusing it.
Plan plan_for(const Scene& scene, const fs::path& folder, bool overwrite) {
    const std::optional<EarlierSummary> summary = read_summary(folder / "summary.json");
    if (summary) {
        if (overwrite && (summary->config != scene.resolved || summary->version != program_version()))
            return Plan::start;
        refuse_other_scene(summary->config, scene, folder);
        if (summary->finished) return complete(scene, folder) ? Plan::nothing : Plan::start;
    }
    const fs::path file = folder / "checkpoint.h5";
    if (!fs::exists(file)) return Plan::start;
    const Checkpoint checkpoint = read_checkpoint(file);
    if (overwrite && checkpoint.config != scene.resolved) return Plan::start;
    refuse_other_scene(checkpoint.config, scene, folder);
    const bool unfinished = checkpoint.progress.stage < scene.stages.size();
    return unfinished && checkpoint.version == program_version() ? Plan::resume : Plan::start;
}

/// Removes what an earlier run left, so that no old file is taken for a result of the new one.
void clear(const Scene& scene, const fs::path& folder) {
    for (const char* name : {"summary.json", "checkpoint.h5", "energy.csv", "trajectory.vtkhdf", "fault.vtkhdf"}) {
        fs::remove(folder / name);
    }
    for (const Stage& stage : scene.stages) fs::remove(folder / (stage.name + ".vtkhdf"));
    fs::remove_all(folder / "trajectory.frames");
}

void make_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (!fs::is_directory(folder) || access(folder.c_str(), W_OK) != 0) {
        throw InputError(folder.string() + ": the folder cannot be made or written to; choose another for --out");
    }
}

int start(const Scene& scene, const RunOptions& options, const EngineFactory& factory) {
    clear(scene, options.folder);
    const ParticleTable particles = initial_particles(scene);
    const auto engine = factory.make(engine_setup(scene, options.threads), particles, scene.walls);
    RunProgress progress;
    progress.start = engine->ledger();
    return StageRunner(scene, options, *engine, progress).run();
}

int continue_from(const Scene& scene, const Checkpoint& checkpoint, const RunOptions& options,
                  const EngineFactory& factory) {
    const auto engine = factory.restore(engine_setup(scene, options.threads), checkpoint.engine);
    ProgressLine line(options.quiet, 0);
    if (checkpoint.version != program_version()) {
        line.say("Note: the checkpoint was written by version " + checkpoint.version + ", this is " +
                 program_version() + ".");
    }
    line.say("Continuing at step " + std::to_string(engine->step()) + ".");
    return StageRunner(scene, options, *engine, checkpoint.progress).run();
}

}  // namespace

int run_scene(const Scene& scene, const RunOptions& options, const EngineFactory& factory) {
    make_folder(options.folder);
    const Plan plan = plan_for(scene, options.folder, options.overwrite);
    if (plan == Plan::nothing) {
        ProgressLine(options.quiet, 0).say(options.folder.string() + ": this run is finished already; nothing to do.");
        return 0;
    }
    if (plan == Plan::start) return start(scene, options, factory);
    return continue_from(scene, read_checkpoint(options.folder / "checkpoint.h5"), options, factory);
}

int resume_run(const RunOptions& options, const EngineFactory& factory) {
    const fs::path file = options.folder / "checkpoint.h5";
    const Checkpoint checkpoint = read_checkpoint(file);
    Scene scene = read_scene(Config::parse(checkpoint.config, file.string()), options.folder);
    scene.resolved = checkpoint.config;
    const std::optional<EarlierSummary> summary = read_summary(options.folder / "summary.json");
    if (summary && summary->finished && complete(scene, options.folder)) {
        ProgressLine(options.quiet, 0).say(options.folder.string() + ": this run is finished already; nothing to do.");
        return 0;
    }
    return continue_from(scene, checkpoint, options, factory);
}

}  // namespace recoat
