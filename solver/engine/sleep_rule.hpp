#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "solver/contact/coefficients.hpp"
#include "solver/engine/engine.hpp"

namespace recoat {

/// When a particle is quiet, from what cannot be seen in a bed [docs/decisions/0011-sleep.md]. Quiet is who has stayed
/// within `reach` of one place for `rest` steps, and has not turned faster than `turn` at any look. A look is due
/// before a wave has gone through more than the layer of particles that is awake around what moves.
///
/// The reach is a tenth of the overlap by which a sphere of the smallest size rests under its own weight; the rest
/// is a thirtieth of the time in which a particle falls its diameter d_p: a net force of more than some 1e-3 of the
/// weight shows within it. Without gravity nothing sleeps.
struct SleepRule {
    double reach = 0;                 ///< [m]
    double turn = 0;                  ///< of the surface by spin: `reach` in `look_for_first` [m/s]
    std::int64_t rest = 0;            ///< [steps]
    std::int64_t look = 0;            ///< steps between looks where some sleep; 0: nothing ever sleeps
    std::int64_t look_for_first = 0;  ///< steps between looks where nobody sleeps, a multiple of `look`

    [[nodiscard]] bool due(std::int64_t step, bool some_sleep) const {
        return look > 0 && step % interval(some_sleep) == 0;
    }
    /// Step of the next look after `step`.
    [[nodiscard]] std::int64_t next(std::int64_t step, bool some_sleep) const {
        if (look == 0) return std::numeric_limits<std::int64_t>::max();
        return step - step % interval(some_sleep) + interval(some_sleep);
    }

    static constexpr double share_of_overlap = 0.1, falls = 30, looks_per_rest = 64;
    /// Who is quiet may go so much further before that counts as motion.
    static constexpr double patience = 2;

private:
    [[nodiscard]] std::int64_t interval(bool some_sleep) const { return some_sleep ? look : look_for_first; }
};

/// `smallest`: radius of the smallest particle [m].
inline SleepRule sleep_rule(const EngineSetup& setup, double smallest) {
    SleepRule rule;
    const double weight_per_mass = norm(setup.gravity);
    if (!setup.sleep || !(weight_per_mass > 0)) return rule;
    const double mass = sphere_mass(smallest, setup.model.density);
    const double hertz = contact_scale(setup.model, true).at(smallest, mass).hertz;
    const double overlap = std::pow(mass * weight_per_mass / hertz, 2.0 / 3);
    const double fall = std::sqrt(2 * setup.diameter / weight_per_mass);
    rule.reach = SleepRule::share_of_overlap * overlap;
    rule.rest = std::max<std::int64_t>(1, std::llround(fall / SleepRule::falls / setup.time_step));
    rule.look = std::max<std::int64_t>(1, std::llround(static_cast<double>(rule.rest) / SleepRule::looks_per_rest));
    rule.look_for_first = 4 * rule.look;
    rule.turn = rule.reach / (static_cast<double>(rule.look_for_first) * setup.time_step);
    return rule;
}

}  // namespace recoat
