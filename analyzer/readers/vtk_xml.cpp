#include "analyzer/readers/vtk_xml.hpp"

#include <fmt/format.h>

#include "analyzer/readers/vtk_array.hpp"
#include "analyzer/readers/vtk_points.hpp"
#include "analyzer/readers/xml_tree.hpp"
#include "common/error.hpp"
#include "common/number.hpp"
#include "common/tables/text_cursor.hpp"

namespace recoat {
namespace {

constexpr std::string_view end_tag = "</VTKFile>";
constexpr std::size_t largest_ratio = 1032;  // of zlib

class XmlReader {
public:
    XmlReader(const Content& content, const ColumnNames& chosen) : file_(content.name()), chosen_(chosen) {
        document_ = parse_xml(content.bytes, file_, "AppendedData");
        const bool whole = trimmed(std::string_view(content.bytes)).ends_with(end_tag);
        if (document_.root.name != "VTKFile" || !whole) {
            throw InputError(
                fmt::format("{}: the file does not go from <VTKFile> to </VTKFile>; copy it again from where it was "
                            "made",
                            file_));
        }
        encoding_ = array_encoding(document_, file_);
        most_points_ = (encoding_.compressed ? largest_ratio : 1) * content.bytes.size();
    }

    VtkPoints read() {
        const std::string type = document_.root.attribute("type");
        const XmlElement* grid = document_.root.child(type);
        if ((type != "PolyData" && type != "UnstructuredGrid") || grid == nullptr) {
            fail(document_.root, fmt::format("the data set is of the kind \"{}\", which holds no particles; give "
                                             "PolyData or UnstructuredGrid",
                                             quotable(type)));
        }
        for (const XmlElement& piece : grid->children) {
            if (piece.name == "Piece") read_piece(piece);
        }
        return std::move(points_);
    }

private:
    void read_piece(const XmlElement& piece) {
        const auto count = parse_integer(piece.attribute("NumberOfPoints"));
        if (!count || *count < 0) fail(piece, "the piece does not say its NumberOfPoints; copy the file again");
        const auto size = static_cast<std::size_t>(*count);
        if (size == 0) return;
        if (size > most_points_ - points_.position.size()) {
            fail(piece, fmt::format(
                            "the piece says that it has {} points, more in all than a file of this size can hold; copy "
                            "the file again",
                            size));
        }
        const XmlElement* points = piece.child("Points");
        const XmlElement* array = points == nullptr ? nullptr : points->child("DataArray");
        if (array == nullptr) fail(piece, "the piece has no Points; copy the file again");
        const std::vector<double> flat = read_array(*array, size, 3, encoding_, file_);
        points_.append_positions(flat);
        if (const XmlElement* data = piece.child("PointData")) read_point_data(*data, size);
        check_arrays(piece);
    }

    void read_point_data(const XmlElement& data, std::size_t count) {
        for (const XmlElement& array : data.children) {
            const std::string name = array.attribute("Name"), components = array.attribute("NumberOfComponents", "1");
            const std::size_t width = components == "1" ? 1 : components == "3" ? 3 : 0;
            if (array.name == "DataArray") points_.offer(name);
            if (array.name != "DataArray" || !VtkPoints::wanted(name, width, chosen_)) continue;
            if (is_there(name, width)) {
                fail(array, fmt::format("the array \"{}\" is there twice; give it once", quotable(name)));
            }
            points_.append(name, width, read_array(array, count, width, encoding_, file_));
            if (VtkPoints::holds_identities(name, width)) {
                points_.append_identities(read_whole_array(array, count, encoding_, file_));
            }
        }
    }

    /// Whether the column has values for the points of this piece already, the last that were read.
    [[nodiscard]] bool is_there(const std::string& name, std::size_t width) const {
        const auto column = points_.find(name, width);
        return column && points_.arrays[*column].size() == points_.position.size();
    }

    void check_arrays(const XmlElement& piece) const {
        for (std::size_t i = 0; i < points_.names.size(); ++i) {
            if (points_.arrays[i].size() == points_.position.size()) continue;
            fail(piece,
                 fmt::format("the array \"{}\" is not there once in every piece; give pieces with the same arrays",
                             quotable(points_.names[i])));
        }
    }

    [[noreturn]] void fail(const XmlElement& element, const std::string& problem) const {
        throw InputError(fmt::format("{}:{}: {}", file_, element.line, problem));
    }

    std::string file_;
    const ColumnNames& chosen_;
    XmlDocument document_;
    ArrayEncoding encoding_;
    std::size_t most_points_ = 0;  ///< that the file can hold
    VtkPoints points_;
};

}  // namespace

bool is_vtk_xml(const Content& content) {
    return trimmed(content.head()).starts_with('<') && content.head().find("<VTKFile") != std::string_view::npos;
}

Series open_vtk_xml(const Content& content, const ReadOptions& options) {
    return single_step(
        [&] { return particles_from(XmlReader(content, options.columns).read(), options.columns, content.name()); });
}

}  // namespace recoat
