#include "tests/stress/ledger_rows.hpp"

#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>

#include "common/error.hpp"
#include "common/number.hpp"
#include "solver/output/ledger_fields.hpp"

namespace recoat::stress {
namespace {

std::string header() {
    std::string names = "step,time_s";
    for (const LedgerField& field : ledger_fields) names.append(",").append(field.name).append("_J");
    return names;
}

/// The cells of a line, all of them; also an empty one at its end.
std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::stringstream stream(line + ",");
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
    return cells;
}

/// The ledger of a line, which must be of `step`.
EnergyLedger ledger_of(const std::string& line, std::int64_t step) {
    const std::vector<std::string> cells = cells_of(line);
    const std::string where = "energy.csv, row of step " + std::to_string(step);
    if (cells.size() != 2 + ledger_fields.size())
        throw InputError(where + ": " + std::to_string(cells.size()) + " cells");
    if (parse_integer(cells[0]) != step) throw InputError(where + ": its step is " + cells[0]);
    EnergyLedger ledger;
    for (std::size_t k = 0; k < ledger_fields.size(); ++k) {
        const std::optional<double> value = parse_number(cells[k + 2]);
        if (!value || !std::isfinite(*value))
            throw InputError(where + ": " + std::string(ledger_fields[k].name) + " is \"" + cells[k + 2] + "\"");
        ledger.*ledger_fields[k].value = *value;
    }
    return ledger;
}

}  // namespace

std::vector<EnergyLedger> read_ledger_rows(const std::filesystem::path& file, std::int64_t steps,
                                           std::int64_t interval) {
    std::ifstream stream(file);
    std::string line;
    if (!stream) throw InputError("energy.csv is missing");
    if (!std::getline(stream, line) || line != header()) throw InputError("energy.csv has other columns: " + line);
    if (interval <= 0) throw InputError("the scene asks for no energy.csv");
    std::vector<EnergyLedger> rows;
    while (std::getline(stream, line))
        rows.push_back(ledger_of(line, static_cast<std::int64_t>(rows.size()) * interval));
    const std::int64_t expected = steps / interval + 1;
    if (static_cast<std::int64_t>(rows.size()) != expected)
        throw InputError("energy.csv has " + std::to_string(rows.size()) + " rows, not " + std::to_string(expected));
    return rows;
}

}  // namespace recoat::stress
