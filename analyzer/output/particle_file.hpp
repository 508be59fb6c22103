#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "analyzer/readers/source.hpp"

namespace recoat {

/// A file of particles in the making; it appears at finish(), whole, or not at all.
class ParticleWriter {
public:
    virtual ~ParticleWriter() = default;
    /// Adds a time step. Throws InputError when the format cannot hold it.
    virtual void add(const Source& source) = 0;
    /// Throws InputError when the file cannot be written.
    virtual void finish() = 0;
};

/// A format that particles are written in.
struct ParticleFormat {
    std::string_view name, ending;
    bool several_steps = false;  ///< whether a file can hold more than one
    /// What particles can have that a file of this format has no place for.
    bool keeps_box = false, keeps_step = false, keeps_time = false, keeps_run = false, keeps_type_names = false;
    std::unique_ptr<ParticleWriter> (*open)(const std::filesystem::path& place) = nullptr;
};

/// The format of this name, or, without one, that of the ending of the file: csv (.csv), vtp (.vtp), lammps-dump
/// (.dump, .lammpstrj), vtkhdf (.vtkhdf, .hdf), extended-xyz (.xyz). Throws InputError when there is none.
[[nodiscard]] const ParticleFormat& particle_format(const std::filesystem::path& place, const std::string& name);

/// What of these particles a file of the format cannot hold, as a list for a sentence; empty where it holds everything.
[[nodiscard]] std::string not_kept(const ParticleFormat& format, const Source& source);

/// Writes the particles of one time step. Positions and radii in metres, to the last bit, the identities, and the
/// velocities where the particles have them. Throws InputError as particle_format() does, or when the file cannot be
/// written.
void write_particle_file(const std::filesystem::path& place, const std::string& format, const Source& source);

}  // namespace recoat
