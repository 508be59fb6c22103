#pragma once

#include "common/hdf5.hpp"
#include "common/state.hpp"

namespace recoat {

/// Calls `visit(name, member)` for every attribute of /recoat: one list for writing and reading.
template <class Info, class Visit>
void for_each_attribute(Info& info, const Visit& visit) {
    visit("schema_version", info.schema_version);
    visit("program_version", info.program_version);
    visit("config", info.config);
    visit("backend", info.backend);
    visit("stage", info.stage);
    visit("seed", info.seed);
    visit("diameter", info.diameter);
    visit("density", info.density);
    visit("y_min", info.y_min);
    visit("y_period", info.y_period);
    visit("clearance", info.clearance);
    visit("blade_start", info.blade_start);
    visit("spread_length", info.spread_length);
    visit("bond_number", info.bond_number);
    visit("hamaker", info.hamaker);
    visit("stiffness_ratio", info.stiffness_ratio);
    visit("time_step", info.time_step);
}

/// Writes the attributes of /recoat. Lengths in m, density in kg/m3, Hamaker constant in J, time step in s.
void write_info(const hdf5::Group& group, const StateInfo& info);

/// Reads them.
StateInfo read_info(const hdf5::Group& group);

}  // namespace recoat
