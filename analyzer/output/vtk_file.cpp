#include "analyzer/output/vtk_file.hpp"

#include <bit>

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <fmt/format.h>

#include "common/output_file.hpp"

namespace recoat {

namespace {

void append_base64(std::string& text, std::string_view bytes) {
    using boost::archive::iterators::base64_from_binary;
    using boost::archive::iterators::transform_width;
    using Encoded = base64_from_binary<transform_width<const char*, 6, 8>>;
    text.append(Encoded(bytes.data()), Encoded(bytes.data() + bytes.size()));
    text.append((3 - bytes.size() % 3) % 3, '=');
}

}  // namespace

static_assert(std::endian::native == std::endian::little && sizeof(Vec3) == 3 * sizeof(double));

VtkFile::VtkFile(std::string type, const std::string& attributes) : type_(std::move(type)) {
    text_ = fmt::format(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"{0}\" version=\"1.0\" byte_order=\"LittleEndian\" "
        "header_type=\"UInt64\">\n<{0}{1}{2}>\n",
        type_, attributes.empty() ? "" : " ", attributes);
}

void VtkFile::array(const std::string& name, const std::vector<double>& values) {
    add(name, "Float64", 1, values.data(), values.size() * sizeof(double));
}

void VtkFile::array(const std::string& name, const std::vector<std::int64_t>& values) {
    add(name, "Int64", 1, values.data(), values.size() * sizeof(std::int64_t));
}

void VtkFile::array(const std::string& name, const std::vector<Vec3>& values) {
    add(name, "Float64", 3, values.data(), values.size() * sizeof(Vec3));
}

void VtkFile::add(const std::string& name, const char* type, int components, const void* data, std::uint64_t bytes) {
    std::string block(reinterpret_cast<const char*>(&bytes), sizeof bytes);
    if (bytes > 0) block.append(static_cast<const char*>(data), bytes);
    text_ += fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">\n", type,
                         name, components);
    append_base64(text_, block);
    text_ += "\n</DataArray>\n";
}

void VtkFile::write(const std::filesystem::path& place) const {
    TextFile file(place);
    file.add(text_);
    file.add(fmt::format("</{}>\n</VTKFile>\n", type_));
    file.finish();
}

void begin_piece(VtkFile& file, const PolyCells& cells, bool polygons) {
    file.text(
        fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"0\" NumberOfStrips=\"0\" "
                    "NumberOfPolys=\"{}\">\n<Points>\n",
                    cells.points.size(), polygons ? 0 : cells.ends.size(), polygons ? cells.ends.size() : 0));
    file.array("Points", cells.points);
    file.text(polygons ? "</Points>\n<Polys>\n" : "</Points>\n<Verts>\n");
    file.array("connectivity", cells.corners);
    file.array("offsets", cells.ends);
    file.text(polygons ? "</Polys>\n" : "</Verts>\n");
}

}  // namespace recoat
