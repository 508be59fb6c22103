#include "solver/output/energy_balance.hpp"

#include <algorithm>
#include <cmath>

namespace recoat {

namespace {

double motion_and_springs(const EnergyLedger& ledger) {
    return ledger.kinetic_translation + ledger.kinetic_rotation + ledger.elastic_normal + ledger.elastic_tangential;
}

double held_in(const EnergyLedger& ledger) {
    return motion_and_springs(ledger) + std::abs(ledger.gravity) + std::abs(ledger.cohesion);
}

}  // namespace

double EnergyBalance::scale() const { return std::max(exchanged, rounding * held); }

double EnergyBalance::relative_error() const { return scale() > 0 ? error / scale() : 0; }

EnergyBalance energy_balance(const EnergyLedger& start, const EnergyLedger& end) {
    EnergyBalance balance;
    balance.wall_work = end.wall_work - start.wall_work;
    balance.dissipated = end.dissipated() - start.dissipated();
    const double kept = end.stored() + end.removed_with_walls - start.stored() - start.removed_with_walls;
    balance.error = kept + balance.dissipated - balance.wall_work;
    balance.held = std::max(held_in(start), held_in(end));
    balance.exchanged = motion_and_springs(start) + motion_and_springs(end) + std::abs(balance.wall_work) +
                        std::abs(balance.dissipated) + std::abs(end.gravity - start.gravity) +
                        std::abs(end.cohesion - start.cohesion) +
                        std::abs(end.removed_with_walls - start.removed_with_walls);
    return balance;
}

}  // namespace recoat
