#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "solver/scene/engine_factory.hpp"
#include "solver/scene/scene.hpp"

namespace recoat {

struct RunOptions {
    std::filesystem::path folder;  ///< where everything is written
    Resources resources;
    bool quiet = false;
    bool overwrite = false;                  ///< replace a run of another configuration
    std::optional<std::int64_t> until_step;  ///< stop there with a checkpoint
    std::string name = {};                   ///< before lines of progress, where several run at the same time
};

/// Runs all stages of `scene` and returns the exit code: 0 when it finished or reached `until_step`; 128 + signal, the
/// convention of shells, when a signal stopped it (with a checkpoint).
///
/// A folder with a finished run of the same scene is left as it is; an unfinished one is
/// continued; that of another scene is refused with InputError. SimulationFault after a fault, with the state of the
/// moment before in DIR/fault.vtkhdf.
int run_scene(const Scene& scene, const RunOptions& options, const EngineFactory& factory);

/// Whether `options.folder` holds a finished run of this scene, so that run_scene would leave it as it is. Throws
/// InputError where run_scene would refuse the folder.
bool is_finished(const Scene& scene, const RunOptions& options);

/// Continues the run in `options.folder` to the bit. Throws InputError when there is nothing to continue.
int resume_run(const RunOptions& options, const EngineFactory& factory);

}  // namespace recoat
