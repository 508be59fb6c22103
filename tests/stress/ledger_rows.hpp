#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "solver/engine/engine.hpp"

namespace recoat::stress {

/// The ledgers of FOLDER/energy.csv of a run of `steps` steps, one every `interval` steps from step 0 on.
///
/// Throws InputError where the file is not that: missing, of other columns, with rows too few, too many or of other
/// steps, or with a cell that is not a finite number. A series that is cut short must not look like one that balances.
std::vector<EnergyLedger> read_ledger_rows(const std::filesystem::path& file, std::int64_t steps,
                                           std::int64_t interval);

}  // namespace recoat::stress
