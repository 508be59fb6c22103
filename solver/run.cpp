#include "solver/run.hpp"

#include <unistd.h>

#include "common/config.hpp"
#include "common/error.hpp"
#include "common/version.hpp"
#include "solver/output/checkpoint.hpp"
#include "solver/output/folder_lock.hpp"
#include "solver/output/summary.hpp"
#include "solver/progress_line.hpp"
#include "solver/scene/initial_particles.hpp"
#include "solver/scene/read_scene.hpp"
#include "solver/stage_runner.hpp"

namespace recoat {
namespace {

namespace fs = std::filesystem;

/// What to do with a folder.
struct Plan {
    enum Kind { start, resume, nothing } kind = start;
    LatestCheckpoint latest;  ///< to resume from
};

void refuse_other_scene(const std::string& config, const Scene& scene, const fs::path& folder) {
    if (config == scene.resolved) return;
    throw InputError(
        folder.string() +
        ": the folder holds a run of another configuration; choose another folder for --out, or replace it "
        "with --overwrite");
}

/// Whether the states of the first `stages` stages are in place.
bool has_states(const Scene& scene, const fs::path& folder, std::size_t stages) {
    for (std::size_t k = 0; k < stages; ++k) {
        if (!fs::exists(folder / (scene.stages[k].name + ".vtkhdf"))) return false;
    }
    return true;
}

/// Whether every file of a finished run is in place.
bool complete(const Scene& scene, const fs::path& folder) {
    if (!has_states(scene, folder, scene.stages.size())) return false;
    return scene.output.trajectory_interval == 0 || fs::exists(folder / "trajectory.vtkhdf");
}

/// The plan for a folder without a finished run.
Plan plan_for_checkpoint(const Scene& scene, const fs::path& folder, bool overwrite) {
    if (!has_checkpoint(folder)) return {Plan::start, {}};
    try {
        LatestCheckpoint latest = read_latest_checkpoint(folder);
        const Checkpoint& checkpoint = latest.checkpoint;
        if (overwrite && checkpoint.config != scene.resolved) return {Plan::start, {}};
        refuse_other_scene(checkpoint.config, scene, folder);
        const bool whole = has_states(scene, folder, checkpoint.progress.stage);
        if (!whole || checkpoint.version != program_version()) return {Plan::start, {}};
        return {Plan::resume, std::move(latest)};
    } catch (const InputError&) {
        if (overwrite) return {Plan::start, {}};  // a damaged one, too
        throw;
    }
}

/// `overwrite` replaces a run of another configuration, a finished one of another version, and damaged checkpoints,
/// instead of refusing them.
Plan plan_for(const Scene& scene, const fs::path& folder, bool overwrite) {
    const std::optional<EarlierSummary> summary = read_summary(folder / "summary.json");
    if (summary) {
        if (overwrite && (summary->config != scene.resolved || summary->version != program_version()))
            return {Plan::start, {}};
        refuse_other_scene(summary->config, scene, folder);
        if (summary->finished) return {complete(scene, folder) ? Plan::nothing : Plan::start, {}};
    }
    return plan_for_checkpoint(scene, folder, overwrite);
}

/// Removes what an earlier run left, so that no old file is taken for a result of the new one.
void clear(const Scene& scene, const fs::path& folder) {
    for (const char* name : {"summary.json", "energy.csv", "walls.vtkhdf", "trajectory.vtkhdf", "fault.vtkhdf"}) {
        fs::remove(folder / name);
    }
    remove_checkpoints(folder);
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
    const auto engine = factory.make(engine_setup(scene, options.resources), particles, scene.walls);
    RunProgress progress;
    progress.start = engine->ledger();
    return StageRunner(scene, options, *engine, progress).run();
}

int continue_from(const Scene& scene, const LatestCheckpoint& latest, const RunOptions& options,
                  const EngineFactory& factory) {
    const Checkpoint& checkpoint = latest.checkpoint;
    const auto engine = factory.restore(engine_setup(scene, options.resources), checkpoint.engine);
    ProgressLine line(options.quiet, 0, options.name);
    if (!latest.note.empty()) line.say("Note: " + latest.note);
    if (checkpoint.version != program_version()) {
        line.say("Note: the checkpoint was written by version " + checkpoint.version + ", this is " +
                 program_version() + ".");
    }
    line.say("Continuing at step " + std::to_string(engine->step()) + ".");
    return StageRunner(scene, options, *engine, checkpoint.progress).run();
}

/// Runs `body`; what the file system refuses it is the user's to mend.
template <class Body>
int with_folder(const RunOptions& options, const Body& body) {
    try {
        const FolderLock lock(options.folder);
        return body();
    } catch (const fs::filesystem_error& error) {
        throw InputError(options.folder.string() + ": the folder cannot be used (" + error.what() +
                         "); check its permissions and the free space");
    }
}

int run_in_folder(const Scene& scene, const RunOptions& options, const EngineFactory& factory) {
    const Plan plan = plan_for(scene, options.folder, options.overwrite);
    if (plan.kind == Plan::nothing) {
        ProgressLine(options.quiet, 0).say(options.folder.string() + ": this run is finished already; nothing to do.");
        return 0;
    }
    remove_unfinished_files(options.folder);
    if (plan.kind == Plan::start) return start(scene, options, factory);
    return continue_from(scene, plan.latest, options, factory);
}

int resume_in_folder(const RunOptions& options, const EngineFactory& factory) {
    const LatestCheckpoint latest = read_latest_checkpoint(options.folder);
    const std::string& config = latest.checkpoint.config;
    Scene scene = read_scene(Config::parse(config, (options.folder / "checkpoint.h5").string()), options.folder);
    scene.resolved = config;
    const std::optional<EarlierSummary> summary = read_summary(options.folder / "summary.json");
    if (summary && summary->finished && complete(scene, options.folder)) {
        ProgressLine(options.quiet, 0).say(options.folder.string() + ": this run is finished already; nothing to do.");
        return 0;
    }
    make_folder(options.folder);
    remove_unfinished_files(options.folder);
    return continue_from(scene, latest, options, factory);
}

}  // namespace

int run_scene(const Scene& scene, const RunOptions& options, const EngineFactory& factory) {
    make_folder(options.folder);
    return with_folder(options, [&] { return run_in_folder(scene, options, factory); });
}

bool is_finished(const Scene& scene, const RunOptions& options) {
    return plan_for(scene, options.folder, options.overwrite).kind == Plan::nothing;
}

int resume_run(const RunOptions& options, const EngineFactory& factory) {
    return with_folder(options, [&] { return resume_in_folder(options, factory); });
}

}  // namespace recoat
