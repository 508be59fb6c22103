#pragma once

#include <string>
#include <vector>

#include "analyzer/readers/source.hpp"

namespace recoat {

/// Leaves out the particles that are not to be kept. kept: [N].
void keep(Source& source, const std::vector<bool>& kept);

/// Names of the types of particles, as they can be listed in a sentence.
[[nodiscard]] std::string list_types(const Source& source);

/// Leaves out the particles whose types the user does not want. Throws InputError when the file gives no types, or none
/// of those that are asked for is there.
void choose_types(Source& source, const std::string& file, const ReadOptions& options);

/// Gives the particles the radii of their types [m]. Throws InputError when a type has none.
void set_radius_of_types(Source& source, const std::string& file, const ReadOptions& options);

/// Leaves out particles of size 0, with a warning that says how many.
void leave_out_size_zero(Source& source, const std::string& file);

}  // namespace recoat
