#pragma once

#include "analyzer/readers/reader.hpp"

namespace recoat {

/// Stage of a state that was made of another code's file: its base may lie anywhere.
inline constexpr const char* converted_stage = "converted";

/// Whether the file is HDF5 with the group of recoat-solve.
bool is_recoat_state(const Content& content);

/// A state of a VTKHDF file that recoat-solve wrote, with what it says about its run. Column names do not apply.
Series open_recoat_state(const Content& content, const ReadOptions& options);

inline constexpr Reader recoat_state_reader = {"recoat-state", "states of recoat-solve (VTKHDF)", is_recoat_state,
                                               open_recoat_state};

}  // namespace recoat
