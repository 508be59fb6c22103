#include "tests/analyzer/reader_fixture.hpp"

namespace recoat {
namespace {

using testing::begins;
using testing::message_of;
using testing::replaced;

const std::string old_text =
    "# vtk DataFile Version 2.0\nlayer\nASCII\nDATASET POLYDATA\nPOINTS 2 float\n1 2 3 4 5\n6\n"
    "VERTICES 2 4\n1 0\n1 1\nCELL_DATA 2\nSCALARS radius float\nLOOKUP_TABLE default\n9 9\n"
    "POINT_DATA 2\nVECTORS v float\n0 0 0 0 0 0\nSCALARS diameter double 1\nLOOKUP_TABLE default\n1\n0.5\n"
    "FIELD more 2\nstress 2 2 double\n1 2\n3 4\nid 1 2 int\n7 8\n";

const std::string xml_text =
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\">\n<PolyData>\n"
    "<Piece NumberOfPoints=\"1\">\n<PointData>\n<DataArray type=\"Float64\" Name=\"Radius\" format=\"ascii\">0.5\n"
    "</DataArray>\n</PointData>\n<Points>\n<DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">\n"
    "1 2 3\n</DataArray>\n</Points>\n</Piece>\n</PolyData>\n</VTKFile>\n";

class Vtk : public testing::ReaderTest {};

TEST_F(Vtk, LegacyText) {
    const Source source = read(old_text);
    EXPECT_EQ(source.format, "legacy-vtk");
    EXPECT_EQ(source.position, (std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}}));
    EXPECT_EQ(source.radius, (std::vector<double>{0.5, 0.25}));
    EXPECT_EQ(source.id, (std::vector<std::int64_t>{7, 8}));
}

TEST_F(Vtk, LegacyDamaged) {
    const auto with = [&](const std::string& from, const std::string& to) {
        return error(replaced(old_text, from, to));
    };
    EXPECT_TRUE(begins(with("4 5\n6", "4 x5\n6"), "layer:6: character 9: \"x5\" is no number"));
    EXPECT_TRUE(begins(with("4 5\n6", "4 nan\n6"), "layer: particle 1 has the centre (4, nan, 6)"));
    EXPECT_TRUE(begins(with("1\n0.5", "1\n-0.5"), "layer: particle 1 has the centre (4, 5, 6) and the radius -0.25"));
    EXPECT_TRUE(begins(with("7 8", "7 7"), "layer: particle 1: the id 7 has been given to another"));
    EXPECT_TRUE(begins(with("POINT_DATA 2", "POINT_DATA 3"), "layer:15: there are data for 3 points, but"));
    EXPECT_TRUE(begins(with("POINTS 2", "POINTS 99999999"), "layer:5: \"99999999\" is no number of points that"));
    EXPECT_TRUE(begins(with("POINTS 2", "POINTS 200"), "layer:8: character 1: \"VERTICES\" is no number"));
    EXPECT_TRUE(begins(with("VERTICES", "VORTICES"), "layer:8: \"VORTICES\" is no keyword"));
    EXPECT_TRUE(begins(with("ASCII", "ASKII"), "layer:3: the third line says \"ASKII\""));
    EXPECT_TRUE(begins(with("ASCII", "BINARY"), "layer: byte "));
    // Found by fuzzing: points behind the arrays that were read for fewer.
    EXPECT_TRUE(begins(error(old_text + "POINTS 1 float\n7 8 9\n"), "layer:28: the file has POINTS twice"));
    EXPECT_TRUE(begins(error(old_text.substr(0, 80)), "layer:"));
    const std::string box =
        message_of<InputError>([] { (void)read_particles(data("liggghts-custom-boundingBox_452000.vtk")); });
    EXPECT_NE(box.find(":4: the data set is of the kind RECTILINEAR_GRID, which holds no particles"), box.npos) << box;
}

TEST_F(Vtk, LegacyTextThatEndsInsideALine) {
    EXPECT_TRUE(begins(error(old_text.substr(0, old_text.size() - 1)), "layer:27: the file ends inside this line"));
    EXPECT_EQ(read(old_text + "  ").id.size(), 2U);
}

TEST_F(Vtk, IdentitiesKeepEveryBit) {
    const std::vector<std::int64_t> large = {1152921504606846977, -9223372036854775807};
    EXPECT_EQ(read(replaced(old_text, "int\n7 8", "vtktypeint64\n1152921504606846977 -9223372036854775807")).id, large);
    EXPECT_EQ(read(replaced(old_text, "int\n7 8", "double\n7.0 8e0")).id, (std::vector<std::int64_t>{7, 8}));
    // Numbers that are not whole are no identities, which is said.
    const Source none = read(replaced(old_text, "int\n7 8", "double\n7.5 8"));
    EXPECT_TRUE(none.id.empty());
    ASSERT_EQ(none.warnings.size(), 1U);
    EXPECT_NE(none.warnings[0].find("the array \"id\" holds other than whole numbers"), std::string::npos);
    const std::string id = "<DataArray type=\"Int64\" Name=\"id\" format=\"ascii\">1152921504606846977</DataArray>\n";
    EXPECT_EQ(read(replaced(xml_text, "</PointData>", id + "</PointData>")).id[0], large[0]);
    // The same number in base64, behind a header that says eight bytes.
    const std::string packed =
        "<DataArray type=\"UInt64\" Name=\"id\" format=\"binary\">CAAAAAEAAAAAAAAQ</DataArray>\n";
    EXPECT_EQ(read(replaced(xml_text, "</PointData>", packed + "</PointData>")).id[0], large[0]);
}

TEST_F(Vtk, XmlText) {
    const Source source = read(xml_text);
    EXPECT_EQ(source.format, "vtk-xml");
    EXPECT_EQ(source.position, (std::vector<Vec3>{{1, 2, 3}}));
    EXPECT_EQ(source.radius, (std::vector<double>{0.5}));
    // The user's name goes before the usual ones.
    ReadOptions options;
    options.columns.diameter = "Size";
    EXPECT_EQ(read(replaced(xml_text, "Radius", "size"), options).radius[0], 0.25);
    // Names from the file come cut and in plain letters.
    EXPECT_FALSE(error(replaced(xml_text, "Radius", "radius\xc3\xa4"), options).find("\xc3") != std::string::npos);
    EXPECT_TRUE(begins(error(xml_text, options), "layer: there is no column \"Size\"; the file has: radius"));
}

TEST_F(Vtk, XmlDamaged) {
    const auto with = [&](const std::string& from, const std::string& to) {
        return error(replaced(xml_text, from, to));
    };
    EXPECT_TRUE(begins(with("1 2 3", "1 2"), "layer:10: the array \"\" has 2 numbers instead of 3"));
    EXPECT_TRUE(begins(with("1 2 3", "1 y 3"), "layer:11: \"y\" is no number"));
    EXPECT_TRUE(begins(with("0.5", "-0.5"), "layer: particle 0 has the centre (1, 2, 3) and the radius -0.5"));
    EXPECT_TRUE(begins(with("</Points>", "</Pints>"), "layer:13: column 3: the file is no whole XML file (mismatched"));
    EXPECT_TRUE(
        begins(with("type=\"PolyData\"", "type=\"ImageData\""), "layer:2: the data set is of the kind \"Image"));
    EXPECT_TRUE(
        begins(with("format=\"ascii\">0.5", "format=\"binary\">AAAA"), "layer:6: the array \"Radius\" ends too"));
    EXPECT_TRUE(begins(with("format=\"ascii\">0.5", "format=\"appended\" offset=\"7\">"),
                       "layer:6: the array \"Radius\" has the offset \"7\" into 0 bytes"));
    EXPECT_TRUE(begins(with("type=\"PolyData\"", "type=\"PolyData\" compressor=\"vtkLZ4DataCompressor\""),
                       "layer:2: the data are compressed by vtkLZ4DataCompressor; write them with zlib"));
    // 3 x 2^61 doubles take 0 bytes in 64 bits.
    for (const std::string count : {"2", "1152921504606846976", "2305843009213693952", "6148914691236517206"}) {
        const std::string more = replaced(xml_text, "NumberOfPoints=\"1\"", "NumberOfPoints=\"" + count + "\"");
        EXPECT_TRUE(begins(error(more), count == "2" ? "layer:10: the array \"\" has 3 numbers instead of 6"
                                                     : "layer:4: the piece says that it has " + count + " points"));
    }
    // The same bytes again and again would make many points of few.
    const std::size_t begin = xml_text.find("<Piece"), end = xml_text.find("</PolyData>");
    const std::string piece = xml_text.substr(begin, end - begin);
    std::string pieces = piece;
    for (int i = 0; i < 3; ++i) pieces += piece;
    EXPECT_EQ(read(replaced(xml_text, piece, pieces)).position.size(), 4U);
    const std::string array = "<DataArray type=\"Float64\" Name=\"Radius\" format=\"ascii\">0.5\n</DataArray>\n";
    EXPECT_TRUE(
        begins(error(replaced(xml_text, array, array + array)), "layer:8: the array \"Radius\" is there twice"));
    for (std::size_t size = 60; size + 2 < xml_text.size(); size += 7) {
        EXPECT_TRUE(begins(error(xml_text.substr(0, size)), "layer:")) << size;
    }
}

}  // namespace
}  // namespace recoat
