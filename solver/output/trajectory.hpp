#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "common/state.hpp"

namespace recoat {

/// States on the way. Each is a whole file in DIR/trajectory.frames as soon as it is added, so that an interrupted run
/// loses none and a resumed one writes the same again; `assemble` joins them into DIR/trajectory.vtkhdf.
class Trajectory {
public:
    explicit Trajectory(const std::filesystem::path& folder);

    /// Writes frame number `index`, replacing one that an interrupted run left, and returns its fingerprint.
    [[nodiscard]] std::uint64_t add(std::size_t index, const StateInfo& info, const State& state) const;
    /// Names of those of the first `count` frames that are neither there nor in the joined file.
    [[nodiscard]] std::vector<std::string> missing(std::size_t count) const;
    /// Joins the frames with these fingerprints and removes their folder. Does nothing when that has been done; where
    /// it was interrupted while it removed them, it takes the frames that are gone from the file that it had made.
    /// Throws InputError when a frame is damaged.
    void assemble(const std::vector<std::uint64_t>& fingerprints, const StateInfo& info) const;

private:
    [[nodiscard]] std::filesystem::path frame(std::size_t index) const;
    [[nodiscard]] State read(std::size_t index, std::uint64_t fingerprint) const;

    std::filesystem::path file_, frames_;
};

}  // namespace recoat
