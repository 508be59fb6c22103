#pragma once

#include <chrono>
#include <optional>

#include "common/error.hpp"
#include "solver/energy_watch.hpp"
#include "solver/output/progress.hpp"
#include "solver/output/summary.hpp"
#include "solver/output/trajectory.hpp"
#include "solver/progress_line.hpp"
#include "solver/run.hpp"

namespace recoat {

/// Takes an engine through the stages of a scene from wherever `progress` says it is, and writes all output.
class StageRunner {
public:
    StageRunner(const Scene& scene, const RunOptions& options, Engine& engine, RunProgress progress);

    /// Exit code of the run.
    int run();

private:
    using Clock = std::chrono::steady_clock;

    void write_stage(const Stage& stage) const;
    void remake_last_state();
    // Each returns false when the run was stopped before the end.
    bool run_stage(const Stage& stage);
    bool run_segment(const Segment& segment);

    void enter(const Segment& segment);
    void leave(const Segment& segment);
    [[nodiscard]] std::int64_t chunk(const Segment& segment) const;
    void advance(std::int64_t steps);
    void sample();
    void watch();
    void check_rest(const Segment& segment);
    void finish_stage(const Stage& stage);
    void finish_run();
    [[nodiscard]] bool at_rest(const Segment& segment) const {
        return segment.rest && progress_.checks_at_rest >= segment.rest->checks;
    }
    [[nodiscard]] bool must_stop() const;
    int stop();

    void save_checkpoint();
    void save_if_due();
    void summarise(RunStatus status);
    void count_time();
    [[nodiscard]] std::int64_t stage_steps() const { return engine_.step() - progress_.stage_first_step; }
    void keep_blade_stop(const std::string& blade);
    [[nodiscard]] std::size_t wall_index(const std::string& name) const;
    [[noreturn]] void fault(const SimulationFault& error);

    const Scene& scene_;
    const RunOptions& options_;
    Engine& engine_;
    RunProgress progress_;
    Trajectory trajectory_;
    std::size_t particles_;
    ProgressLine line_;
    EnergyWatch energy_watch_;
    std::int64_t chunk_limit_ = 64;  ///< adapted, so that a chunk takes about a quarter of a second
    Clock::time_point counted_, saved_;
};

}  // namespace recoat
