#include "tests/analyzer/reader_fixture.hpp"

namespace recoat {
namespace {

using testing::begins;

class YadeText : public testing::ReaderTest {};

TEST_F(YadeText, FormatsAndComments) {
    for (const std::string text : {"#format x_y_z_r\n1\t2\t3\t0.5\n4\t5\t6\t0.25\n",
                                   "#format x_y_z_r_attrs\n# layer\n1 2 3 0.5 9 8 7\n4 5 6 0.25 9 8 7\n",
                                   "# made by hand\n#format id_x_y_z_r_matId\n7 1 2 3 0.5 0\n8 4 5 6 0.25 0\n"}) {
        const Source source = read(text);
        EXPECT_EQ(source.format, "yade-text") << text;
        EXPECT_EQ(source.position, (std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}})) << text;
        EXPECT_EQ(source.radius, (std::vector<double>{0.5, 0.25})) << text;
    }
}

TEST_F(YadeText, RealFile) {
    const Source source = read_particles(data("yade-text.txt"));
    ASSERT_EQ(source.position.size(), 100U);
    EXPECT_EQ(source.position[0], (Vec3{0.00472133, 0.000852146, 0.000317497}));
    EXPECT_EQ(source.radius[99], 2.5e-5);
}

TEST_F(YadeText, DamagedFiles) {
    EXPECT_TRUE(begins(error("#format x_y_z_r\n1 2 3 4\n1 2 3 4"), "layer:3: the file ends inside this line"));
    EXPECT_TRUE(begins(error("#format x_y_z_r\n1 2 3\n"), "layer:2: the line has 3 columns, 4 or more are expected"));
    EXPECT_TRUE(begins(error("#format x_y_z_r\n1 2 3 4\n1 2 3 4 5\n"), "layer:3: the line has 5 columns, 4 are"));
    EXPECT_TRUE(begins(error("#format x_y_z_r\n1 2 NaN 4\n"), "layer:2: column 3 (z): \"NaN\": the number is not fin"));
    EXPECT_TRUE(begins(error("#format x_y_z_r\n1 2 3 -4\n"), "layer:2: column 4 (r): \"-4\": a particle must have"));
    EXPECT_TRUE(begins(error("#format jointedPM\n"), "layer:1: the format \"jointedPM\" is not known"));
    EXPECT_TRUE(begins(error("#format id_x_y_z_r\n1 1 2 3 4\n1 1 2 3 4\n"), "layer:3: the id 1 has been given"));
}

}  // namespace
}  // namespace recoat
