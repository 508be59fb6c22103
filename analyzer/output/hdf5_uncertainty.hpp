#pragma once

#include "analyzer/output/described_group.hpp"
#include "analyzer/uncertainty/uncertainty.hpp"

namespace recoat {

/// Writes every quantity as a group of value, lower, upper, standard_error and, for lists, items; below the groups of
/// the report.
void write_uncertainty(const hdf5::Group& group, const Uncertainty& uncertainty);

}  // namespace recoat
