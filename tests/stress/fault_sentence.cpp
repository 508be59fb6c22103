#include "tests/stress/fault_sentence.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <regex>

#include "common/number.hpp"
#include "solver/engine/limits.hpp"

namespace recoat::stress {
namespace {

const std::string particle = "particle (\\d+)";
const std::string partner = "(?:particle (\\d+)|wall '([^']+)')";
const std::string number = "[-+0-9.e]+";
const std::string start = "recoat-solve: error: step (\\d+)(?: \\(t = " + number + " s\\))?: ";
const std::string end = "\\. The state of the moment before is in [^\\n]*fault\\.vtkhdf\\.\\n";

std::regex sentence_of(const std::string& middle) { return std::regex(start + middle + end); }

std::optional<std::int64_t> whole(const std::ssub_match& match) {
    if (!match.matched) return {};
    return std::strtoll(match.str().c_str(), nullptr, 10);
}

/// Of a sentence with step, particle, partner, wall in this order.
FaultSentence of_contact(const std::smatch& found) {
    FaultSentence result;
    result.step = *whole(found[1]);
    result.particle = whole(found[2]);
    result.partner = whole(found[3]);
    if (found[4].matched) result.wall = found[4].str();
    return result;
}

FaultSentence of_particle(const std::smatch& found) {
    FaultSentence result;
    result.step = *whole(found[1]);
    result.particle = whole(found[2]);
    return result;
}

/// Index of the particle `id`, or the number of particles.
std::size_t place_of(const State& state, std::int64_t id) {
    return static_cast<std::size_t>(std::ranges::find(state.id, id) - state.id.begin());
}

double overlap_of(const State& state, std::size_t i, std::size_t j, double y_period) {
    Vec3 way = state.position[i] - state.position[j];
    if (y_period > 0) way.y = std::remainder(way.y, y_period);
    return state.radius[i] + state.radius[j] - norm(way);
}

}  // namespace

std::optional<FaultSentence> read_fault_sentence(const std::string& sentence) {
    static const std::regex overlap = sentence_of(particle + " overlaps " + partner + " by (" + number +
                                                  ") m, more than [^\\n]*: reduce time_step[^\\n]*");
    static const std::regex speed =
        sentence_of(particle + " would be faster than " + number + " m/s, [^\\n]*; reduce time_step[^\\n]*");
    static const std::regex domain =
        sentence_of(particle + " at \\([^\\n]*\\) m has left the domain; add a wall [^\\n]*");
    const std::string energy = "energy (?:appears|vanishes): " + number + " J, [^\\n]* not accounted for; [^\\n]*\\(";
    static const std::regex touching = sentence_of(energy + "the stiffest contact now is that of " + particle +
                                                   " and " + partner + ", [^\\n]*\\): reduce time_step");
    static const std::regex apart =
        sentence_of(energy + "nothing touches now, and " + particle + " is the fastest\\): reduce time_step");
    std::smatch found;
    if (std::regex_match(sentence, found, overlap)) {
        FaultSentence result = of_contact(found);
        result.overlap = std::strtod(found[5].str().c_str(), nullptr);
        return result;
    }
    if (std::regex_match(sentence, found, touching)) return of_contact(found);
    for (const std::regex& form : {speed, domain, apart}) {
        if (std::regex_match(sentence, found, form)) return of_particle(found);
    }
    return {};
}

std::optional<std::string> unusable(const std::string& sentence, const State& state,
                                    const std::vector<std::string>& walls, double y_period) {
    const std::optional<FaultSentence> read = read_fault_sentence(sentence);
    if (!read) return "it is none of the sentences about a fault";
    if (read->step != state.step) return "the state is of step " + std::to_string(state.step);
    const std::size_t first = place_of(state, *read->particle);
    if (first == state.size()) return "there is no particle " + std::to_string(*read->particle);
    if (read->wall && std::ranges::find(walls, *read->wall) == walls.end()) return "there is no wall " + *read->wall;
    if (!read->partner) return {};
    const std::size_t second = place_of(state, *read->partner);
    if (second == state.size()) return "there is no particle " + std::to_string(*read->partner);
    if (first == second) return "a particle is its own partner";
    if (!read->overlap) return {};
    // Of the limit that the overlap passed, this is what two spheres can go in one step.
    constexpr double share = 2 * limits::travel_per_step / limits::overlap;
    const double before = overlap_of(state, first, second, y_period);
    if (!(std::abs(before - *read->overlap) <= share * *read->overlap))
        return "the two spheres overlap by " + shortest(before) + " m in fault.vtkhdf";
    return {};
}

}  // namespace recoat::stress
