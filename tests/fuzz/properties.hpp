#pragma once

#include <functional>
#include <string_view>

#include "analyzer/readers/reader.hpp"

namespace recoat::fuzz {

/// Stops the fuzzer with a message unless `holds`.
void require(bool holds, std::string_view what);

/// Runs `read`, which may refuse its input by InputError with one clean sentence, and nothing else.
void must_read_or_refuse(const std::function<void()>& read);

/// Reads the first time steps with usual and with unusual options. Particles that come out must be whole: as many
/// radii as positions, all finite, radii above zero, identities unique.
void check_reader(const Reader& reader, const Content& content);

/// What particles from any reader must satisfy.
void check_source(const Source& source);

}  // namespace recoat::fuzz
