#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/vec3.hpp"

namespace recoat {

/// When particles count as settled: at `checks` checks in a row the mean kinetic energy of all but some stragglers is
/// below `energy`, so that a heap that is about to collapse is not taken for one at rest, and nobody waits for the last
/// sphere that rolls.
struct RestCriterion {
    double energy = 0;          ///< per particle [J]
    std::int64_t interval = 1;  ///< steps between checks
    std::int64_t checks = 10;
    std::optional<std::int64_t> stragglers;  ///< particles that may still move; none: stragglers_among()

    /// A quarter of the square root of their number: a quarter of what the number of as many independent particles
    /// scatters by from one placement to the next [docs/accuracy.md].
    static std::int64_t stragglers_among(std::size_t particles) {
        return static_cast<std::int64_t>(0.25 * std::sqrt(static_cast<double>(particles)));
    }

    friend bool operator==(const RestCriterion&, const RestCriterion&) = default;
};

/// A wall that moves while a segment lasts and stands still afterwards.
struct WallMotion {
    std::string wall;
    Vec3 velocity;  ///< [m/s]

    friend bool operator==(const WallMotion&, const WallMotion&) = default;
};

/// A stretch of a run under constant conditions: remove walls, set walls moving, make steps, stop the walls.
struct Segment {
    std::vector<std::string> removed;  ///< walls taken away at its start
    std::vector<WallMotion> motions;
    std::int64_t steps = 0;             ///< at most, where there is a rest criterion
    std::optional<RestCriterion> rest;  ///< ends the segment early

    friend bool operator==(const Segment&, const Segment&) = default;
};

/// A named part of a run; its state at the end is written to NAME.vtkhdf.
struct Stage {
    std::string kind;  ///< fill, heap, spread, move, remove, settle or run
    std::string name;  ///< unique in the run
    std::vector<Segment> segments;

    /// Steps at most.
    [[nodiscard]] std::int64_t steps() const {
        std::int64_t sum = 0;
        for (const Segment& segment : segments) sum += segment.steps;
        return sum;
    }
    /// Whether it may end before `steps()`.
    [[nodiscard]] bool may_end_early() const {
        for (const Segment& segment : segments) {
            if (segment.rest) return true;
        }
        return false;
    }
};

}  // namespace recoat
