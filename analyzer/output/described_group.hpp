#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <string>
#include <vector>

#include "analyzer/fields/map.hpp"
#include "common/hdf5.hpp"

namespace recoat {

/// A group of an HDF5 file whose arrays all carry the attributes `unit` and `definition`.
class DescribedGroup {
public:
    explicit DescribedGroup(hdf5::Group group) : group_(std::move(group)) {}

    void column(const std::string& name, const std::string& unit, const std::string& definition,
                const std::vector<double>& values) const {
        group_.write(name, values);
        describe(name, unit, definition);
    }

    /// Whole numbers of any type.
    template <std::integral Number>
    void column(const std::string& name, const std::string& unit, const std::string& definition,
                const std::vector<Number>& values) const {
        std::vector<std::int64_t> whole(values.size());
        std::ranges::transform(values, whole.begin(), [](Number value) { return static_cast<std::int64_t>(value); });
        group_.write(name, whole);
        describe(name, unit, definition);
    }

    void value(const std::string& name, const std::string& unit, const std::string& definition, double number) const {
        column(name, unit, definition, std::vector<double>{number});
    }
    void value(const std::string& name, const std::string& unit, const std::string& definition,
               std::size_t number) const {
        column(name, unit, definition, std::vector<std::size_t>{number});
    }

    void map(const std::string& name, const std::string& unit, const std::string& definition, const Map& map) const {
        group_.write(name, map.values, {static_cast<std::size_t>(map.nx), static_cast<std::size_t>(map.ny)}, true);
        describe(name, unit, definition);
        group_.set_dataset_attribute(name, "axes", "ix, iy");
    }

    [[nodiscard]] DescribedGroup group(const std::string& name) const {
        return DescribedGroup(group_.create_group(name));
    }

private:
    void describe(const std::string& name, const std::string& unit, const std::string& definition) const {
        group_.set_dataset_attribute(name, "unit", unit);
        group_.set_dataset_attribute(name, "definition", definition);
    }

    hdf5::Group group_;
};

}  // namespace recoat
