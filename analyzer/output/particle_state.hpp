#pragma once

#include <optional>
#include <vector>

#include "analyzer/output/particle_file.hpp"
#include "common/state.hpp"

namespace recoat {

/// Particles as states of recoat-solve (VTKHDF). What the particles do not have is not in the file; all time steps of a
/// file must have the same.
class StateFileWriter : public ParticleWriter {
public:
    explicit StateFileWriter(std::filesystem::path place) : place_(std::move(place)) {}
    void add(const Source& source) override;
    void finish() override;

private:
    void append(State state);

    std::filesystem::path place_;
    std::optional<StateInfo> info_;
    std::optional<StateWriter> writer_;
    std::vector<State> without_particles_;  ///< before the first state that shows which arrays there are
    State first_;                           ///< that state
};

}  // namespace recoat
