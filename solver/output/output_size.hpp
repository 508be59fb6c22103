#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "solver/engine/engine.hpp"
#include "solver/scene/scene.hpp"

namespace recoat {

/// Bytes that a run writes at most, when no stage ends before its settle_time.
struct OutputSize {
    std::int64_t frames = 0;  ///< states of the trajectory
    double frame = 0;         ///< each of them
    double states = 0;        ///< after the stages
    double checkpoints = 0;   ///< the last two
    double series = 0;        ///< energy.csv

    /// What is left in the end.
    [[nodiscard]] double left() const { return trajectory() + states + checkpoints + series; }
    /// What there is at most at one time: the states of the trajectory are joined into one file before they are
    /// removed.
    [[nodiscard]] double most() const { return left() + trajectory() + 0.5 * checkpoints; }
    [[nodiscard]] double trajectory() const { return static_cast<double>(frames) * frame; }
};

/// `checkpoint`: bytes of one [engine_bytes].
OutputSize output_size(const Scene& scene, std::int64_t particles, double checkpoint);

/// Bytes of all that an engine saves.
double engine_bytes(const EngineState& state);

/// Bytes free for the user on the disk of `folder`, which need not exist yet; infinite where the system does not say.
double free_bytes(const std::filesystem::path& folder);

/// A sentence where the disk of `folder` has less than the output takes; else empty.
std::string space_note(const OutputSize& size, const std::filesystem::path& folder);

}  // namespace recoat
