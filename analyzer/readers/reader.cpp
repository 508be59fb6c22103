#include "analyzer/readers/reader.hpp"

#include <array>
#include <string>

#include <fmt/format.h>

#include "analyzer/readers/complete.hpp"
#include "analyzer/readers/csv.hpp"
#include "analyzer/readers/lammps_data.hpp"
#include "analyzer/readers/lammps_dump.hpp"
#include "analyzer/readers/legacy_vtk.hpp"
#include "analyzer/readers/mercury_data.hpp"
#include "analyzer/readers/recoat_state.hpp"
#include "analyzer/readers/vtk_xml.hpp"
#include "analyzer/readers/yade_text.hpp"
#include "common/error.hpp"

namespace recoat {
namespace {

constexpr std::array all_readers = {recoat_state_reader, lammps_dump_reader, lammps_data_reader, yade_text_reader,
                                    mercury_data_reader, legacy_vtk_reader,  vtk_xml_reader,     csv_reader};

}  // namespace

std::span<const Reader> readers() { return all_readers; }

Source read_particles(const std::filesystem::path& file, const ReadOptions& options) {
    const Content content = load_content(file);
    std::string known;
    for (const Reader& reader : all_readers) {
        if (reader.recognises(content)) {
            Source source = reader.read(content, options);
            source.format = reader.name;
            complete(source, content.name(), options);
            return source;
        }
        known += fmt::format("{}{}", known.empty() ? "" : "; ", reader.description);
    }
    throw InputError(fmt::format("{}: the format is not known; known are: {}", content.name(), known));
}

}  // namespace recoat
