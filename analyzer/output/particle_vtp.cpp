#include "analyzer/output/particle_vtp.hpp"

#include <bit>
#include <cstdint>
#include <numeric>
#include <string>

#include <fmt/format.h>

#include "common/output_file.hpp"

namespace recoat {
namespace {

static_assert(std::endian::native == std::endian::little && sizeof(Vec3) == 3 * sizeof(double));

/// Arrays behind each other, each behind its length.
class AppendedData {
public:
    /// The element that describes the array.
    template <class Value>
    std::string add(const std::string& name, const char* type, int components, const std::vector<Value>& values) {
        const std::string element =
            fmt::format(R"(<DataArray type="{}" Name="{}" NumberOfComponents="{}" format="appended" offset="{}"/>)",
                        type, name, components, bytes_.size());
        const std::uint64_t size = values.size() * sizeof(Value);
        bytes_.append(reinterpret_cast<const char*>(&size), sizeof size);
        bytes_.append(reinterpret_cast<const char*>(values.data()), size);
        return element + "\n";
    }
    [[nodiscard]] const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
};

}  // namespace

void write_vtp(const std::filesystem::path& place, const Source& source) {
    const std::size_t count = source.position.size();
    std::vector<std::int64_t> number(count);
    std::iota(number.begin(), number.end(), std::int64_t{0});
    std::vector<std::int64_t> end = number;
    for (std::int64_t& value : end) ++value;
    AppendedData data;
    std::string text =
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PolyData>\n";
    text += fmt::format(
        "<Piece NumberOfPoints=\"{0}\" NumberOfVerts=\"{0}\" NumberOfLines=\"0\" NumberOfStrips=\"0\" "
        "NumberOfPolys=\"0\">\n",
        count);
    text += "<PointData Scalars=\"Radius\">\n" + data.add("Radius", "Float64", 1, source.radius);
    if (!source.id.empty()) text += data.add("Id", "Int64", 1, source.id);
    text += "</PointData>\n<Points>\n" + data.add("Points", "Float64", 3, source.position) + "</Points>\n";
    text += "<Verts>\n" + data.add("connectivity", "Int64", 1, number) + data.add("offsets", "Int64", 1, end);
    text += "</Verts>\n</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
    text += data.bytes();
    text += "\n</AppendedData>\n</VTKFile>\n";
    write_text_file(place, text);
}

}  // namespace recoat
