#pragma once

#include "analyzer/output/particle_file.hpp"
#include "common/output_file.hpp"

namespace recoat {

/// A text file of particles: the text of a time step behind that of the one before.
class ParticleTextWriter : public ParticleWriter {
public:
    ParticleTextWriter(const std::filesystem::path& place, std::string (*text)(const Source&))
        : file_(place), text_(text) {}
    void add(const Source& source) override { file_.add(text_(source)); }
    void finish() override { file_.finish(); }

private:
    TextFile file_;
    std::string (*text_)(const Source&);
};

/// A table with the columns id and type (where the particles have them), x, y, z, radius, and the velocities.
[[nodiscard]] std::string csv_text(const Source& source);
/// A snapshot of a LAMMPS dump, with the box of the file, or else that of the particles.
[[nodiscard]] std::string dump_text(const Source& source);
/// A frame of extended XYZ, with the box of the file, or else that of the particles.
[[nodiscard]] std::string xyz_text(const Source& source);

struct CsvWriter : ParticleTextWriter {
    explicit CsvWriter(const std::filesystem::path& place) : ParticleTextWriter(place, csv_text) {}
};
struct DumpWriter : ParticleTextWriter {
    explicit DumpWriter(const std::filesystem::path& place) : ParticleTextWriter(place, dump_text) {}
};
struct XyzWriter : ParticleTextWriter {
    explicit XyzWriter(const std::filesystem::path& place) : ParticleTextWriter(place, xyz_text) {}
};

}  // namespace recoat
