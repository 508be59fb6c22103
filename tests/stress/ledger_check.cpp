#include "tests/stress/ledger_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>
#include <vector>

#include "common/number.hpp"
#include "solver/energy_watch.hpp"
#include "solver/output/energy_balance.hpp"
#include "solver/output/ledger_fields.hpp"
#include "solver/scene/contact_frequency.hpp"

namespace recoat::stress {
namespace {

constexpr double rounding = 1e-6;  ///< of sums that cancel, over what was exchanged

std::vector<EnergyLedger> read_ledgers(const std::filesystem::path& file) {
    std::ifstream stream(file);
    std::vector<EnergyLedger> rows;
    std::string line;
    for (bool header = true; std::getline(stream, line); header = false) {
        if (header) continue;
        std::stringstream cells(line);
        std::string cell;
        for (int skipped = 0; skipped < 2; ++skipped) std::getline(cells, cell, ',');
        EnergyLedger& ledger = rows.emplace_back();
        for (const LedgerField& field : ledger_fields) {
            std::getline(cells, cell, ',');
            ledger.*field.value = parse_number(cell).value_or(NAN);
        }
    }
    return rows;
}

}  // namespace

LedgerCheck check_ledger(const Scene& scene, const std::filesystem::path& energy, double largest_overlap,
                         const ParticleTable& start) {
    LedgerCheck result;
    const double radius = std::ranges::min(start.radius), density = scene.model.density;
    for (const ContactPartners& partners : {pair_of(radius, radius, density), with_wall(radius, density)})
        result.step =
            std::max(result.step, scene.time_step * contact_frequency(scene.model, partners, largest_overlap));
    result.bound = std::min(result.step + rounding, EnergyWatch::limit);
    const std::vector<EnergyLedger> rows = read_ledgers(energy);
    for (const EnergyLedger& row : rows) {
        const double scale = energy_scale(scene, rows.front(), row, start);
        result.error = std::max(result.error, std::abs(energy_balance(rows.front(), row).error) / scale);
    }
    return result;
}

}  // namespace recoat::stress
