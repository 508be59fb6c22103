#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/state.hpp"

namespace recoat::stress {

/// What a sentence about a fault says; absent where it does not say it.
struct FaultSentence {
    std::int64_t step = -1;
    std::optional<std::int64_t> particle, partner;  ///< identities
    std::optional<std::string> wall;                ///< name of the wall that is the partner
    std::optional<double> overlap;                  ///< of both, where that is the cause [m]
};

/// Reads the whole sentence of a run that stopped. Nothing if it is not one of the four that there are:
///
/// - overlap: names particle and partner (particle or wall), the overlap and what to do;
/// - speed: names the particle, which has no partner;
/// - domain: names the particle, which has no partner;
/// - energy: names both partners of the stiffest contact, or the fastest particle where nothing touches.
std::optional<FaultSentence> read_fault_sentence(const std::string& sentence);

/// What is wrong with `sentence`, or nothing: it must be whole, be of the step of `state`, name particles and walls
/// that there are, two different ones for a contact, and two spheres of which the overlap in `state`, the moment
/// before, is that of the sentence but for what both can go in one step. `y_period` [m], 0: none.
std::optional<std::string> unusable(const std::string& sentence, const State& state,
                                    const std::vector<std::string>& walls, double y_period);

}  // namespace recoat::stress
