#include "tests/stress/ledger_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "common/error.hpp"
#include "solver/energy_watch.hpp"
#include "solver/output/energy_balance.hpp"
#include "solver/scene/contact_frequency.hpp"
#include "tests/stress/ledger_rows.hpp"

namespace recoat::stress {
namespace {

constexpr double rounding = 1e-6;  ///< of sums that cancel, over what was exchanged

}  // namespace

LedgerCheck check_ledger(const Scene& scene, const std::filesystem::path& energy, std::int64_t steps,
                         double largest_overlap, const ParticleTable& start) {
    if (!std::isfinite(largest_overlap)) throw InputError("the largest overlap is not a finite number");
    LedgerCheck result;
    const double radius = std::ranges::min(start.radius), density = scene.model.density;
    for (const ContactPartners& partners : {pair_of(radius, radius, density), with_wall(radius, density)})
        result.step =
            std::max(result.step, scene.time_step * contact_frequency(scene.model, partners, largest_overlap));
    result.bound = std::min(result.step + rounding, EnergyWatch::limit);
    const double mass = total_mass(start, density);
    const std::vector<EnergyLedger> rows = read_ledger_rows(energy, steps, scene.output.energy_interval);
    for (const EnergyLedger& row : rows) {
        const double scale = energy_scale(scene, rows.front(), row, mass);
        const double error = std::abs(energy_balance(rows.front(), row).error) / scale;
        if (!std::isfinite(error)) throw InputError("the balance of energy.csv is not a finite number");
        result.error = std::max(result.error, error);
    }
    return result;
}

}  // namespace recoat::stress
