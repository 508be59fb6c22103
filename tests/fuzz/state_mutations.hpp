#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace recoat::fuzz {

/// The bytes of a state file with two time steps of three particles.
[[nodiscard]] std::string small_state_file();

/// Changes objects of an HDF5 file as `recipe` says, which may be any bytes: arrays get other sizes, types and values,
/// attributes too; links are removed or lead elsewhere.
void mutate(const std::filesystem::path& file, std::span<const std::uint8_t> recipe);

}  // namespace recoat::fuzz
