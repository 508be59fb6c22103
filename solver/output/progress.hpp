#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "solver/engine/engine.hpp"
#include "solver/output/blade_stop.hpp"
#include "solver/output/energy_series.hpp"
#include "solver/output/wall_series.hpp"

namespace recoat {

/// What is kept of a finished stage.
struct StageRecord {
    std::string name;
    std::int64_t steps = 0;
    double time = 0;       ///< simulated [s]
    bool settled = false;  ///< it ended by its rest criterion
    double wall_seconds = 0;
    double kinetic_energy = 0;              ///< at its end [J]
    double largest_overlap = 0;             ///< since the start of the run [d_p]
    std::optional<double> packing_density;  ///< of the bed after filling [paper eq. 14]
    std::optional<double> layer_end;        ///< of the layer that is as the blade left it [m]
    EnergyLedger start, end;
};

/// How far a run has come; together with the engine's state all that is needed to continue to the bit.
struct RunProgress {
    std::size_t stage = 0, segment = 0;
    bool segment_entered = false;     ///< walls removed and set moving
    std::int64_t segment_steps = 0;   ///< done in this segment
    std::int64_t checks_at_rest = 0;  ///< in a row
    bool settled = false;             ///< the last segment ended by its rest criterion
    std::int64_t stage_first_step = 0;
    std::vector<std::uint64_t> frames;  ///< fingerprints of those of the trajectory
    double wall_seconds = 0, stage_wall_seconds = 0;
    EnergyLedger start;
    std::vector<StageRecord> finished;
    EnergySeries energy;
    WallSeries walls;
    BladeStop blade_stop;  ///< the last one
};

/// All but the series, the frames and the places at the stop of the blade as JSON text, and back.
std::string progress_to_text(const RunProgress& progress);
RunProgress progress_from_text(const std::string& text);

}  // namespace recoat
