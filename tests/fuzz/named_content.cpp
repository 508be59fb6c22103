#include "tests/fuzz/named_content.hpp"

#include <map>

#include "common/error.hpp"

namespace recoat::fuzz {

Content load_named(const std::filesystem::path& file) {
    static const std::map<std::string, std::string> files = {
        {"a.vtu",
         "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece NumberOfPoints=\"1\"><Points><DataArray "
         "type=\"Float64\" "
         "NumberOfComponents=\"3\" format=\"ascii\">1 2 3</DataArray></Points><PointData><DataArray type=\"Float64\" "
         "Name=\"radius\" format=\"ascii\">1</DataArray></PointData></Piece></UnstructuredGrid></VTKFile>"},
        {"b.csv", "x,y,z,radius\n1,2,3,0.5\n4,5,6,0.25\n"},
        {"c.pvtu",
         "<VTKFile type=\"PUnstructuredGrid\"><PUnstructuredGrid><Piece "
         "Source=\"a.vtu\"/></PUnstructuredGrid></VTKFile>"},
        {"d.pvd",
         "<VTKFile type=\"Collection\"><Collection><DataSet timestep=\"0\" file=\"c.pvtu\"/></Collection></VTKFile>"}};
    const auto found = files.find(file.string());
    if (found == files.end()) throw InputError("input: the file that it names is not there");
    Content content = make_content(file, found->second);
    content.load = load_named;
    return content;
}

}  // namespace recoat::fuzz
