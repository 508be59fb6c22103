#include "solver/output/energy_series.hpp"

#include <string>

#include "common/number.hpp"
#include "common/output_file.hpp"
#include "solver/output/ledger_fields.hpp"

namespace recoat {

std::size_t EnergySeries::columns() { return 2 + ledger_fields.size(); }

void EnergySeries::add(const Engine& engine) {
    const EnergyLedger ledger = engine.ledger();
    values_.push_back(static_cast<double>(engine.step()));
    values_.push_back(engine.time());
    for (const LedgerField& field : ledger_fields) values_.push_back(ledger.*field.value);
}

void EnergySeries::write_csv(const std::filesystem::path& file) const {
    std::string text = "step,time_s";
    for (const LedgerField& field : ledger_fields) text.append(",").append(field.name).append("_J");
    text += "\n";
    for (std::size_t i = 0; i < values_.size(); ++i) {
        const bool is_step = i % columns() == 0;
        text += is_step ? std::to_string(static_cast<std::int64_t>(values_[i])) : shortest(values_[i]);
        text += (i + 1) % columns() == 0 ? "\n" : ",";
    }
    write_text_file(file, text);
}

}  // namespace recoat
