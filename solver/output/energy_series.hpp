#pragma once

#include <filesystem>
#include <vector>

#include "solver/engine/engine.hpp"

namespace recoat {

/// The energy ledger against time.
class EnergySeries {
public:
    /// Columns: step, time, then the ledger.
    static std::size_t columns();

    void add(const Engine& engine);
    [[nodiscard]] bool empty() const { return values_.empty(); }

    /// Rows one after the other, and back.
    [[nodiscard]] const std::vector<double>& values() const { return values_; }
    void set_values(std::vector<double> values) { values_ = std::move(values); }

    /// Writes a table with the header `step,time_s,kinetic_translation_J,...`; every number reads back as the same
    /// double.
    void write_csv(const std::filesystem::path& file) const;

private:
    std::vector<double> values_;
};

}  // namespace recoat
