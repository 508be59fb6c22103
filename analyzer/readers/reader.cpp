#include "analyzer/readers/reader.hpp"

#include <array>
#include <string>

#include <fmt/format.h>

#include "analyzer/readers/complete.hpp"
#include "analyzer/readers/csv.hpp"
#include "analyzer/readers/edem_queries.hpp"
#include "analyzer/readers/extended_xyz.hpp"
#include "analyzer/readers/foreign_kinds.hpp"
#include "analyzer/readers/lammps_data.hpp"
#include "analyzer/readers/lammps_dump.hpp"
#include "analyzer/readers/legacy_vtk.hpp"
#include "analyzer/readers/mercury_data.hpp"
#include "analyzer/readers/recoat_state.hpp"
#include "analyzer/readers/steps.hpp"
#include "analyzer/readers/vtk_series.hpp"
#include "analyzer/readers/vtk_xml.hpp"
#include "analyzer/readers/vtkhdf.hpp"
#include "analyzer/readers/yade_text.hpp"
#include "common/error.hpp"

namespace recoat {
namespace {

constexpr std::array all_readers = {recoat_state_reader,   vtkhdf_reader,       lammps_dump_reader, lammps_data_reader,
                                    yade_text_reader,      mercury_data_reader, legacy_vtk_reader,  vtk_pieces_reader,
                                    vtk_collection_reader, vtk_series_reader,   vtk_xml_reader,     extended_xyz_reader,
                                    edem_queries_reader,   csv_reader};

const Reader& reader_of(const Content& content) {
    if (const auto kind = foreign_kind(content)) throw InputError(fmt::format("{}: {}", content.name(), *kind));
    for (const Reader& reader : all_readers) {
        if (reader.recognises(content)) return reader;
    }
    if (content.is_hdf5()) {
        throw InputError(fmt::format(
            "{}: this HDF5 file holds no particles that are known (no group VTKHDF); give a state of recoat-solve, or "
            "points as VTKHDF of another code",
            content.name()));
    }
    throw InputError(
        fmt::format("{}: the format is not known; give particles as a table (CSV), as VTK file or extended XYZ, or of "
                    "LAMMPS, LIGGGHTS, Yade, MercuryDPM, EDEM or recoat-solve (all formats: recoat-analyze describe)",
                    content.name()));
}

}  // namespace

Series open_series(const Content& content, const ReadOptions& options) {
    return reader_of(content).open(content, options);
}

std::span<const Reader> readers() { return all_readers; }

Recording::Recording(Content content, ReadOptions options)
    : content_(std::make_unique<Content>(std::move(content))),
      options_(std::make_unique<ReadOptions>(std::move(options))),
      reader_(&reader_of(*content_)),
      series_(reader_->open(*content_, *options_)) {}

Source Recording::read_at(std::size_t index) const {
    Source source = series_.read(index);
    source.format = reader_->name;
    source.step = series_.steps.at(index);
    if (index < series_.times.size()) source.time = series_.times[index];
    complete(source, content_->name(), *options_);
    return source;
}

Source Recording::read(std::size_t index) const {
    Source source = read_at(index);
    if (const auto warning = disorder(series_, {}, content_->name())) source.warnings.push_back(*warning);
    return source;
}

Source Recording::read(StepChoice choice) const {
    const std::size_t index = choose_step(series_, choice, content_->name());
    Source source = read_at(index);
    if (const auto warning = disorder(series_, index, content_->name())) source.warnings.push_back(*warning);
    return source;
}

void Recording::require_whole() const { recoat::require_whole(series_, content_->name()); }

Source read_particles(const std::filesystem::path& file, const ReadOptions& options) {
    return Recording(file, options).read(options.step);
}

}  // namespace recoat
