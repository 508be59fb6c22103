#pragma once

#include <filesystem>

#include "solver/engine/engine.hpp"

namespace recoat {

/// Reads the columns x,y,z,radius,vx,vy,vz,wx,wy,wz (header required in this order; SI: m, m/s, rad/s). Lines that
/// start with # are comments. Throws InputError "file:line: sentence" for anything else.
ParticleTable read_particle_csv(const std::filesystem::path& file);

}  // namespace recoat
