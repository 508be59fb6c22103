#include "analyzer/output/particle_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "analyzer/output/particle_state.hpp"
#include "analyzer/output/particle_text.hpp"
#include "analyzer/output/particle_vtp.hpp"
#include "common/error.hpp"
#include "common/number.hpp"

namespace recoat {
namespace {

namespace fs = std::filesystem;

/// Writes one time step as VTP.
class VtpWriter : public ParticleWriter {
public:
    explicit VtpWriter(fs::path place) : place_(std::move(place)) {}
    void add(const Source& source) override { write_vtp(place_, source); }
    void finish() override {}

private:
    fs::path place_;
};

template <class Writer>
std::unique_ptr<ParticleWriter> open(const fs::path& place) {
    return std::make_unique<Writer>(place);
}

constexpr ParticleFormat csv = {.name = "csv", .ending = ".csv", .keeps_type_names = true, .open = open<CsvWriter>};
constexpr ParticleFormat vtp = {.name = "vtp", .ending = ".vtp", .open = open<VtpWriter>};
constexpr ParticleFormat dump = {.name = "lammps-dump",
                                 .ending = ".dump",
                                 .several_steps = true,
                                 .keeps_box = true,
                                 .keeps_step = true,
                                 .keeps_time = true,
                                 .open = open<DumpWriter>};
constexpr ParticleFormat vtkhdf = {.name = "vtkhdf",
                                   .ending = ".vtkhdf",
                                   .several_steps = true,
                                   .keeps_step = true,
                                   .keeps_time = true,
                                   .keeps_run = true,
                                   .open = open<StateFileWriter>};
constexpr ParticleFormat xyz = {.name = "extended-xyz",
                                .ending = ".xyz",
                                .several_steps = true,
                                .keeps_box = true,
                                .keeps_step = true,
                                .keeps_time = true,
                                .keeps_type_names = true,
                                .open = open<XyzWriter>};

constexpr ParticleFormat with_ending(ParticleFormat format, std::string_view ending) {
    format.ending = ending;
    return format;
}

constexpr std::array formats = {csv, vtp, dump, with_ending(dump, ".lammpstrj"), vtkhdf, with_ending(vtkhdf, ".hdf"),
                                xyz};

bool says_of_run(const SourceInfo& info) {
    return !std::isnan(info.density) || !std::isnan(info.clearance) || !std::isnan(info.blade_start) ||
           !std::isnan(info.spread_length);
}

}  // namespace

const ParticleFormat& particle_format(const fs::path& place, const std::string& name) {
    const std::string ending = place.extension().string();
    const auto found = std::ranges::find_if(formats, [&](const ParticleFormat& known) {
        return name.empty() ? known.ending == ending : known.name == name;
    });
    if (found != formats.end()) return *found;
    throw InputError(fmt::format("{}: {}; give --format csv, vtp, lammps-dump, vtkhdf or extended-xyz", place.string(),
                                 name.empty() ? "the ending tells no format that can be written"
                                              : fmt::format("no format \"{}\" can be written", name)));
}

std::string not_kept(const ParticleFormat& format, const Source& source) {
    std::string list;
    const auto add = [&](bool lost, std::string_view what) {
        if (lost) list += fmt::format("{}{}", list.empty() ? "" : ", ", what);
    };
    const bool only_y = format.keeps_run;  // states hold a period along y
    add(!format.keeps_box && source.box.has_value(), only_y ? "the box (but for its period along y)" : "the box");
    add(!format.keeps_box && !only_y && !source.box && source.info.y_period > 0, "the period along y");
    add(!format.keeps_step && source.step != 0, "the number of the time step");
    add(!format.keeps_time && !std::isnan(source.time), "the time");
    add(!format.keeps_run && says_of_run(source.info), "what the file says of its run (density, clearance, blade)");
    const bool words = std::ranges::any_of(source.type.names, [](const auto& name) { return !parse_integer(name); });
    add(!format.keeps_type_names && !source.type.of.empty() && words, "the names of the types");
    return list;
}

void write_particle_file(const fs::path& place, const std::string& format, const Source& source) {
    const auto writer = particle_format(place, format).open(place);
    writer->add(source);
    writer->finish();
}

}  // namespace recoat
