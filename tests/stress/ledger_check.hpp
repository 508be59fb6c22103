#pragma once

#include <cstdint>
#include <filesystem>

#include "solver/scene/scene.hpp"

namespace recoat::stress {

/// How far energy was not accounted for.
struct LedgerCheck {
    double error = 0;  ///< largest over the rows of energy.csv, over the energy exchanged until then [-]
    double bound = 0;  ///< that it may be [-]
    double step = 0;   ///< time step times the highest contact frequency, w dt [-]
};

/// Checks a finished run that began with `start`; its `largest_overlap` [m] gives the highest frequency.
///
/// The ledger counts powers at the start of a step and kinetic energy at its positions: half a step of power is open at
/// any moment, and a contact that begins within a step has missed up to one. A contact moves its energy in 1/w, so both
/// are at most of the order of w dt of the energy exchanged. A run whose error passes a tenth is stopped by its own
/// watch. So a ledger is closed when its error is below min(w dt, 0.1).
///
/// Throws InputError where `energy` is not the whole series of `steps` steps (read_ledger_rows()), or the balance of a
/// row is not a finite number.
LedgerCheck check_ledger(const Scene& scene, const std::filesystem::path& energy, std::int64_t steps,
                         double largest_overlap, const ParticleTable& start);

}  // namespace recoat::stress
