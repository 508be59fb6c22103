#pragma once

#include <cstdint>
#include <filesystem>

#include "common/state.hpp"

namespace recoat {

/// States on the way. Each is a whole file in DIR/trajectory.frames as soon as it is added, so that an interrupted run
/// loses none and a resumed one writes the same again; `assemble` joins them into DIR/trajectory.vtkhdf.
class Trajectory {
public:
    explicit Trajectory(const std::filesystem::path& folder);

    /// Writes frame number `index`, replacing one that an interrupted run left.
    void add(std::int64_t index, const StateInfo& info, const State& state) const;
    /// Joins the first `count` frames and removes their folder. Does nothing when that has been done.
    void assemble(std::int64_t count, const StateInfo& info) const;

private:
    [[nodiscard]] std::filesystem::path frame(std::int64_t index) const;

    std::filesystem::path file_, frames_;
};

}  // namespace recoat
