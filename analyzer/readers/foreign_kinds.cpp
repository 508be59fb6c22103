#include "analyzer/readers/foreign_kinds.hpp"

#include <array>
#include <string_view>

#include <fmt/format.h>

#include "common/number.hpp"
#include "common/tables/text_cursor.hpp"

namespace recoat {
namespace {

using namespace std::string_view_literals;

/// A kind of file, known by what it begins with (of a text, behind white space).
struct Kind {
    std::string_view beginning, what;
};

constexpr std::string_view unpack_it = "unpack it and give the file of particles in it";
constexpr std::string_view export_it =
    "write the particles as a table (CSV), VTP or LAMMPS dump with the program that made it";

constexpr std::array binary_kinds = {
    Kind{"PK\x03\x04"sv, "a zip archive (or a workbook of Excel); unpack it, or save the sheet as CSV"},
    Kind{"7z\xbc\xaf\x27\x1c"sv, "a 7z archive; unpack it and give the file of particles in it"},
    Kind{"Rar!"sv, "a rar archive; unpack it and give the file of particles in it"},
    Kind{"\x1f\x9d"sv, "packed with compress (.Z); unpack it"},
    Kind{"\x04\x22\x4d\x18"sv, "packed with lz4; unpack it, or pack it with gzip, bzip2, xz or zstd"},
    Kind{"LZIP"sv, "packed with lzip; unpack it, or pack it with gzip, bzip2, xz or zstd"},
    Kind{"\x5d\0\0"sv, "packed with lzma; unpack it, or pack it with gzip, bzip2, xz or zstd"},
    Kind{"\xdf\x65\xdf\x65\xdf\x65\xdf\x65"sv,
         "a GSD file of HOOMD-blue, which is not read; write the particles as extended XYZ"},
    Kind{"\xdf\xe4\xa7\x0c"sv, "a GSD file of HOOMD-blue, which is not read; write the particles as extended XYZ"},
    Kind{"\x65\xdf\x65\xdf\x65\xdf\x65\xdf"sv,
         "a GSD file of HOOMD-blue, which is not read; write the particles as extended XYZ"},
    Kind{"LammpS RestartT"sv, "a restart file of LAMMPS, which only LAMMPS reads; dump the atoms, or write_data"},
    Kind{"CDF\x01"sv, "a NetCDF file, which is not read; dump the atoms as text"},
    Kind{"CDF\x02"sv, "a NetCDF file, which is not read; dump the atoms as text"},
    Kind{"CDF\x05"sv, "a NetCDF file, which is not read; dump the atoms as text"},
    Kind{"\x93NUMPY"sv, "an array of numpy; save it as a table: x, y, z, radius in the first line, then the numbers"},
    Kind{"MATLAB 5.0"sv, "a MATLAB file; write the particles as a table (writetable)"},
    Kind{"\xd0\xcf\x11\xe0"sv, "a document of an old Office; save the sheet as CSV"},
    Kind{"SQLite format 3"sv, "an SQLite database; write the particles as a table (CSV)"},
    Kind{"%PDF"sv, "a PDF document, not particles; give the file that it shows"},
    Kind{"\x89PNG"sv, "a picture, not particles; give the file that it shows"},
    Kind{"\xff\xd8\xff"sv, "a picture, not particles; give the file that it shows"},
    Kind{"GIF8"sv, "a picture, not particles; give the file that it shows"}};

constexpr std::array text_kinds = {
    Kind{"MercuryDPM "sv,
         "a restart file of MercuryDPM, not its list of particles; give the .data file of the same run"},
    Kind{"restart_version"sv,
         "a restart file of MercuryDPM, not its list of particles; give the .data file of the same run"},
    Kind{"solid "sv, "a surface of triangles (STL), not particles; give the file of the particles"},
    Kind{"ply\n"sv, "a PLY file, which is not read; save its points as CSV"},
    Kind{"LAMMPS ("sv, "the log of a LAMMPS run, not particles; give the dump that the run wrote"},
    Kind{"LIGGGHTS ("sv, "the log of a LIGGGHTS run, not particles; give the dump that the run wrote"},
    Kind{"<?xml version=\"1.0\" ?><Xdmf"sv, "an XDMF head, which is not read; save the points as VTP"},
    Kind{"<!DOCTYPE html"sv, "a page of the web, not particles; download the file itself"},
    Kind{"<html"sv, "a page of the web, not particles; download the file itself"},
    Kind{"version https://git-lfs"sv, "a pointer of Git LFS, not the file itself; fetch it with git lfs pull"}};

/// Whether this item stands at the beginning of one of the first lines.
bool has_item(std::string_view head, std::string_view item) {
    return head.starts_with(item) || head.find(fmt::format("\n{}", item)) != std::string_view::npos;
}

/// The data of a head in the style of YAML: LAMMPS's own dump, or the table of another program.
std::optional<std::string> yaml_kind(std::string_view text) {
    if (!(text.starts_with("---") || text.starts_with("%YAML ")) || text.find(':') == std::string_view::npos) return {};
    if (has_item(text, "creator: LAMMPS") || has_item(text, "keywords:")) {
        return "this is a YAML dump of LAMMPS, which is not read; dump the atoms with the style custom";
    }
    return "this is a YAML file, not a list of particles; give the particles as a table (CSV) or dump";
}

/// Fields of phasicFlow and OpenFOAM keep each quantity in a file of its own.
std::optional<std::string> field_kind(std::string_view text) {
    for (const std::string_view code : {"objectType", "FoamFile"}) {
        if (!has_item(text, code)) continue;
        return fmt::format(
            "this is a field of {}, which keeps positions and sizes in files of their own; convert them to VTK "
            "({}) and give that",
            code == "FoamFile" ? "OpenFOAM" : "phasicFlow", code == "FoamFile" ? "foamToVTK" : "pFlowToVTK");
    }
    return {};
}

/// Dumps of LAMMPS that are not of atoms; their lines name what they list.
std::optional<std::string> dump_kind(std::string_view text) {
    if (!text.starts_with("ITEM:") || has_item(text, "ITEM: ATOMS") || has_item(text, "ITEM: NUMBER OF ATOMS"))
        return {};
    if (has_item(text, "ITEM: GRID SIZE") || has_item(text, "ITEM: GRID CELLS")) {
        return "this is a dump of a grid, which holds no particles; give the dump of the atoms";
    }
    constexpr std::string_view counted = "ITEM: NUMBER OF ";
    const std::size_t place = text.find(counted);
    if (place == std::string_view::npos) return {};
    const std::string_view rest = text.substr(place + counted.size());
    const std::string what(trimmed(rest.substr(0, rest.find('\n'))));
    return fmt::format(
        "this dump lists {} (local entries such as contacts or bonds), not particles; give the dump of the atoms",
        lower_case(quotable(what)));
}

/// Text of old Macs, and of spreadsheets that still write it.
bool has_returns_alone(std::string_view head) {
    const std::size_t place = head.find('\r');
    return place != std::string_view::npos && place + 1 < head.size() && head.find('\n') == std::string_view::npos &&
           looks_like_text(head);
}

bool is_tar(std::string_view head) {
    constexpr std::size_t place = 257;
    return head.size() > place && head.substr(place).starts_with("ustar");
}

}  // namespace

std::optional<std::string> foreign_kind(const Content& content) {
    const std::string_view head = content.head();
    for (const Kind& kind : binary_kinds) {
        if (head.starts_with(kind.beginning)) return fmt::format("this is {}", kind.what);
    }
    if (is_tar(head)) return fmt::format("this is a tar archive; {}", unpack_it);
    const std::string_view text = head.substr(std::min(head.find_first_not_of(" \t\r\n"), head.size()));
    for (const Kind& kind : text_kinds) {
        if (text.starts_with(kind.beginning)) return fmt::format("this is {}", kind.what);
    }
    if (has_item(text, "<Xdmf")) return fmt::format("this is an XDMF head, which is not read; {}", export_it);
    if (auto kind = dump_kind(text)) return kind;
    if (auto kind = field_kind(text)) return kind;
    if (has_returns_alone(head)) {
        return "this is text whose lines end with carriage returns alone, which is not read; save it with the line "
               "ends "
               "of Unix or Windows";
    }
    return yaml_kind(text);
}

}  // namespace recoat
