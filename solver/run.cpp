#include "solver/run.hpp"

#include <unistd.h>

#include "common/config.hpp"
#include "common/error.hpp"
#include "common/version.hpp"
#include "solver/other_configuration.hpp"
#include "solver/output/checkpoint.hpp"
#include "solver/output/folder_lock.hpp"
#include "solver/output/output_size.hpp"
#include "solver/output/summary.hpp"
#include "solver/progress_line.hpp"
#include "solver/run_files.hpp"
#include "solver/scene/initial_particles.hpp"
#include "solver/scene/read_scene.hpp"
#include "solver/stage_runner.hpp"
#include "solver/start_overlaps.hpp"

namespace recoat {
namespace {

namespace fs = std::filesystem;

/// What to do with a folder.
struct Plan {
    enum Kind { start, resume, nothing } kind = start;
    LatestCheckpoint latest;  ///< to resume from
    std::string note = {};    ///< why, where that is not plain
};

void refuse_other_scene(const std::string& config, const Scene& scene, const fs::path& folder) {
    if (config == scene.resolved) return;
    throw InputError(folder.string() + ": the folder holds a run of another configuration (" +
                     configuration_differences(config, scene.resolved) +
                     "); choose another folder for --out, or replace it with --overwrite");
}

/// The plan for a folder without a whole finished run.
Plan plan_for_checkpoint(const Scene& scene, const fs::path& folder, bool overwrite) {
    if (!has_checkpoint(folder)) return {Plan::start, {}};
    try {
        LatestCheckpoint latest = read_latest_checkpoint(folder);
        const Checkpoint& checkpoint = latest.checkpoint;
        if (overwrite && checkpoint.config != scene.resolved) return {Plan::start, {}};
        refuse_other_scene(checkpoint.config, scene, folder);
        if (checkpoint.version != program_version())
            return {Plan::start, {}, "the earlier run is of version " + checkpoint.version + "; it starts anew"};
        MissingFiles missing = missing_files(scene, folder, checkpoint.progress);
        missing.states.insert(missing.states.end(), missing.frames.begin(), missing.frames.end());
        if (!missing.states.empty())
            return {Plan::start,
                    {},
                    list_of(missing.states) + " of the earlier run " + (missing.states.size() == 1 ? "is" : "are") +
                        " gone; it starts anew"};
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
        if (summary->finished && missing_of_finished(scene, folder).empty()) return {Plan::nothing, {}};
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

/// What is probably not meant, before the time for it is spent.
void say_notes(const Scene& scene, const RunOptions& options, const Engine& engine) {
    ProgressLine line(options.quiet, 0, options.name);
    const auto particles = static_cast<std::int64_t>(engine.particles().size());
    const OutputSize size = output_size(scene, particles, engine_bytes(engine.save()));
    std::vector<std::string> notes = scene.notes;
    notes.push_back(start_overlaps(scene, engine));
    notes.push_back(space_note(size, options.folder));
    for (const std::string& note : notes) {
        if (!note.empty()) line.say("Note: " + note + ".");
    }
}

int start(const Scene& scene, const RunOptions& options, const EngineFactory& factory) {
    clear(scene, options.folder);
    const ParticleTable particles = initial_particles(scene);
    const auto engine = factory.make(engine_setup(scene, options.resources), particles, scene.walls);
    say_notes(scene, options, *engine);
    RunProgress progress;
    progress.start = engine->ledger();
    return StageRunner(scene, options, *engine, progress).run();
}

/// After its last step a run only writes, which is worth a word where the files were there before.
void say_what_goes_on(const Scene& scene, const fs::path& folder, const RunProgress& progress, std::int64_t step,
                      ProgressLine& line) {
    if (progress.stage < scene.stages.size()) return line.say("Continuing at step " + std::to_string(step) + ".");
    const std::optional<EarlierSummary> summary = read_summary(folder / "summary.json");
    if (!summary || !summary->finished) return;
    const std::vector<std::string> gone = missing_of_finished(scene, folder);
    if (gone.empty()) return;
    line.say(list_of(gone) + (gone.size() == 1 ? " was gone; it is" : " were gone; they are") +
             " made again from the checkpoint.");
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
    const MissingFiles missing = missing_files(scene, options.folder, checkpoint.progress);
    if (!missing.states.empty())
        line.say("Note: not there any more, and not to be made again: " + list_of(missing.states) + ".");
    say_what_goes_on(scene, options.folder, checkpoint.progress, engine->step(), line);
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

int nothing_to_do(const RunOptions& options) {
    ProgressLine(options.quiet, 0, options.name)
        .say(options.folder.string() + ": this run is finished already; nothing to do.");
    return 0;
}

int run_in_folder(const Scene& scene, const RunOptions& options, const EngineFactory& factory) {
    const Plan plan = plan_for(scene, options.folder, options.overwrite);
    if (plan.kind == Plan::nothing) return nothing_to_do(options);
    remove_unfinished_files(options.folder);
    if (!plan.note.empty()) ProgressLine(options.quiet, 0, options.name).say("Note: " + plan.note + ".");
    if (plan.kind == Plan::start) return start(scene, options, factory);
    return continue_from(scene, plan.latest, options, factory);
}

Scene earlier_scene(const std::string& config, const fs::path& file) {
    Scene scene = read_scene(Config::parse(config, file.string()), file.parent_path());
    scene.resolved = config;
    return scene;
}

/// What cannot be made again keeps a run from ever being whole.
void refuse_lost_files(const Scene& scene, const RunProgress& progress, const fs::path& folder) {
    const MissingFiles missing = missing_files(scene, folder, progress);
    const bool at_end = progress.stage == scene.stages.size();
    const std::vector<std::string>& lost = missing.frames.empty() && at_end ? missing.states : missing.frames;
    if (lost.empty()) return;
    throw InputError(folder.string() + ": " + list_of(lost) + (lost.size() == 1 ? " is" : " are") +
                     " gone, and the checkpoint is of a later moment; put it back, or start the run anew with "
                     "recoat-solve run");
}

int resume_in_folder(const RunOptions& options, const EngineFactory& factory) {
    const fs::path summary_file = options.folder / "summary.json";
    const std::optional<EarlierSummary> summary = read_summary(summary_file);
    if (summary && summary->finished &&
        missing_of_finished(earlier_scene(summary->config, summary_file), options.folder).empty())
        return nothing_to_do(options);
    const LatestCheckpoint latest = read_latest_checkpoint(options.folder);
    const Scene scene = earlier_scene(latest.checkpoint.config, options.folder / "checkpoint.h5");
    refuse_lost_files(scene, latest.checkpoint.progress, options.folder);
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
