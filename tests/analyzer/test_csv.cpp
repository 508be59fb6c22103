#include <algorithm>
#include <fstream>

#include <gtest/gtest.h>

#include "analyzer/readers/reader.hpp"
#include "common/error.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/throws_message.hpp"

namespace recoat {
namespace {

using testing::message_of;

::testing::AssertionResult begins(const std::string& text, const std::string& start) {
    if (text.starts_with(start)) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << text;
}

class Csv : public ::testing::Test {
protected:
    Source read(const std::string& text, const ColumnNames& columns = {}) const {
        const auto file = folder_ / "table.csv";
        std::ofstream(file, std::ios::binary) << text;
        return read_particles(file, {.columns = columns});
    }

    /// The message without the folder.
    std::string error(const std::string& text, const ColumnNames& columns = {}) const {
        const std::string message = message_of<InputError>([&] { (void)read(text, columns); });
        const std::string place = folder_.path().string() + "/";
        return message.starts_with(place) ? message.substr(place.size()) : message;
    }

private:
    testing::TemporaryFolder folder_;
};

TEST_F(Csv, SeparatorsOrdersAndSizes) {
    const std::vector<std::string> texts = {
        "x,y,z,radius\n1,2,3,0.5\n4,5,6,0.25\n",
        "x;y;z;radius\r\n1;2;3;0.5\r\n4;5;6;.25\r\n",
        "x y z radius\n1 2 3 0.5\n  4\t5 6   2.5e-1  \n",
        "# radius z y x\n0.5 3 2 1\n0.25 6 5 4",
        "\xEF\xBB\xBFX, Y, Z, Diameter\n\n1, 2, 3, 1\n4, 5, 6, 0.5\n\n",
        "id,\"x\",vx,y,z,d\n9,1,-1,2,3,1\n8,4,0,5,6,+0.5\n",
        "x\ty\tz\tr\n1\t2\t3\t0.5\n4\t5\t6\t0.25\n",
    };
    for (const std::string& text : texts) {
        const Source source = read(text);
        ASSERT_EQ(source.position.size(), 2U) << text;
        EXPECT_EQ(source.position[0], (Vec3{1, 2, 3})) << text;
        EXPECT_EQ(source.position[1], (Vec3{4, 5, 6})) << text;
        EXPECT_EQ(source.radius, (std::vector<double>{0.5, 0.25})) << text;
        EXPECT_EQ(source.format, "csv");
    }
}

TEST_F(Csv, ColumnsByChosenNames) {
    const Source source = read("px,y,z,radius,size\n1,2,3,7,0.5\n",
                               {.x = "PX", .y = {}, .z = {}, .radius = {}, .diameter = "size", .type = {}});
    EXPECT_EQ(source.position[0], (Vec3{1, 2, 3}));
    EXPECT_EQ(source.radius[0], 0.25);
}

TEST_F(Csv, UsualNamesOfOtherPrograms) {
    for (const std::string header : {"pos_x,pos_y,pos_z,radii", "\"Points:0\",\"Points:1\",\"Points:2\",Radius",
                                     "Position_X|position_y|Position_Z|r"}) {
        const char separator = header.find('|') == std::string::npos ? ',' : '|';
        std::string text = header + "\n1,2,3,0.5\n";
        std::ranges::replace(text, ',', separator);
        const Source source = read(text);
        EXPECT_EQ(source.position[0], (Vec3{1, 2, 3})) << header;
        EXPECT_EQ(source.radius[0], 0.5) << header;
    }
}

TEST_F(Csv, UnitsInTheHeader) {
    for (const std::string text :
         {"x [um],y (mm),z [m],diameter[nm]\n1,2,3,4\n", "x [um] y (mm) z (m) diameter [nm]\n1 2 3 4\n"}) {
        const Source source = read(text);
        EXPECT_NEAR(source.position[0].x, 1e-6, 1e-20) << text;
        EXPECT_NEAR(source.position[0].y, 2e-3, 1e-17) << text;
        EXPECT_EQ(source.position[0].z, 3) << text;
        EXPECT_NEAR(source.radius[0], 2e-9, 1e-23) << text;
    }
}

TEST_F(Csv, ALastLineWithoutEndIsReadWithAWarning) {
    const Source source = read("x,y,z,radius\n1,2,3,0.5");
    EXPECT_EQ(source.position.size(), 1U);
    ASSERT_EQ(source.warnings.size(), 1U);
    EXPECT_NE(source.warnings[0].find(":2: the last line has no line end"), std::string::npos);
}

TEST_F(Csv, Identities) {
    EXPECT_EQ(read("id,x,y,z,r\n7,1,2,3,1\n9.0,1,2,3,1\n").id, (std::vector<std::int64_t>{7, 9}));
    EXPECT_TRUE(begins(error("id,x,y,z,r\n7,1,2,3,1\n8,1,2,3,1\n7,1,2,3,1\n"),
                       "table.csv:4: the id 7 has been given to another particle already (line 2)"));
    // Also from a range too wide to mark every number of it, and at the ends of what is exact.
    const std::string far = "id,x,y,z,r\n-9007199254740992,1,2,3,1\n9007199254740992,1,2,3,1\n";
    EXPECT_EQ(read(far).id, (std::vector<std::int64_t>{-(1LL << 53), 1LL << 53}));
    EXPECT_TRUE(begins(error(far + "-9007199254740992,1,2,3,1\n"), "table.csv:4: the id -9007199254740992 has been"));
    EXPECT_TRUE(begins(error("id,x,y,z,r\n7.5,1,2,3,1\n"), "table.csv:2: column 1 (id): \"7.5\": this is no whole"));
    // To the last bit also as some programs write whole numbers.
    EXPECT_EQ(read("id,x,y,z,r\n1152921504606846977.00,1,2,3,1\n").id, (std::vector<std::int64_t>{(1LL << 60) + 1}));
    EXPECT_TRUE(begins(error("id,x,y,z,r\n.,1,2,3,1\n"), "table.csv:2: column 1 (id): \".\": this is no"));
    EXPECT_TRUE(begins(error("id,x,y,z,r\n18446744073709551615,1,2,3,1\n"), "table.csv:2: column 1 (id): \"1844"));
}

// As tables are written from numbers that are none.
TEST_F(Csv, EmptyCellsOfVelocities) {
    const Source source = read("x,y,z,r,vx,vy,vz,wx,wy,wz\n1,2,3,1,,,,7,8,9\n1,2,3,1,4,5,6,7,8,9\n");
    EXPECT_EQ(source.position.size(), 2U);
    EXPECT_TRUE(source.velocity.empty());
    EXPECT_EQ(source.angular_velocity.size(), 2U);
    ASSERT_EQ(source.warnings.size(), 1U);
    EXPECT_NE(source.warnings[0].find(":2: the velocity of this particle is not finite"), std::string::npos);
}

TEST_F(Csv, ATableWithoutLinesHasNoParticles) { EXPECT_TRUE(read("x,y,z,radius\n").position.empty()); }

TEST_F(Csv, ErrorsNameLineAndColumn) {
    EXPECT_EQ(error("x,y,z,radius\n1,2,3,0.5\n1,2,nan,0.5\n"),
              "table.csv:3: column 3 (z): \"nan\": the number is not finite; correct the value or remove the line");
    EXPECT_EQ(error("x,y,z,radius\n1,2,3,-0.5\n"),
              "table.csv:2: column 4 (radius): \"-0.5\": a particle must have a size above zero; correct the value or "
              "remove the line");
    EXPECT_TRUE(begins(error("x,y,z,radius\n1,2,3,0\n"), "table.csv:2: column 4 (radius): \"0\": a "));
    EXPECT_EQ(error("x,y,z,radius\n\n1,2,3o,1\n"),
              "table.csv:3: column 3 (z): \"3o\": this is no number; correct the value or remove the line");
    EXPECT_TRUE(begins(error("x,y,z,radius\n1,2,,1\n"), "table.csv:2: column 3 (z): \"\": "));
    EXPECT_EQ(error("x,y,z,radius\n1,2,3\n"),
              "table.csv:2: the line has 3 columns, the first line names 4; make them agree");
    EXPECT_EQ(error("x,y,z,radius\n1,2,3,4,5\n"),
              "table.csv:2: the line has 5 columns, the first line names 4; make them agree");
    EXPECT_TRUE(begins(error("x,y,z,radius\n1,2,3,1\n1,2,1e999,1\n"), "table.csv:3: column 3 (z): "));
}

TEST_F(Csv, ErrorsOfTheFirstLine) {
    EXPECT_EQ(error("x,y,z,x,radius\n1,2,3,4,5\n"),
              "table.csv:1: the column \"x\" is named twice; give every column its own name");
    EXPECT_EQ(
        error("x,y,radius\n"),
        "table.csv:1: there is no column \"z\" among those of the file (x, y, radius); name it in the first line, "
        "or choose the column: --set columns.x=NAME, --radius-column NAME, --diameter-column NAME; or give one "
        "--radius for all");
    EXPECT_TRUE(
        begins(error("x,y,z\n1,2,3\n"),
               "table.csv:1: there is no column \"radius\" or \"diameter\" among those of the file (x, y, z); "));
    EXPECT_TRUE(begins(error("1,2,3,0.5\n4,5,6,0.5\n"), "table.csv:1: the rows begin here, but no line names the "));
    EXPECT_TRUE(begins(error("x,y,z,r\n", {.x = "east", .y = {}, .z = {}, .radius = {}, .diameter = {}, .type = {}}),
                       "table.csv:1: there is no column \"east\" among those of the file (x, y, z, r); "));
}

TEST_F(Csv, FilesThatAreNoTables) {
    std::string wide = "x";
    for (int i = 0; i < 500'000; ++i) wide.append(",").append(std::to_string(i));
    EXPECT_TRUE(begins(error(wide), "table.csv:1: the line has 500001 columns, which is no table of particles"));
    EXPECT_EQ(error(""), "table.csv: the file is empty; give a file of particles");
    EXPECT_EQ(error("\n \n"), "table.csv: the file has no lines of text; give a table of particles");
    EXPECT_TRUE(
        begins(error(std::string("x,y\0z", 5)), "table.csv: the format is not known; give particles as a table"));
    EXPECT_TRUE(begins(error("\x89HDF\r\n\x1a\n garbage"), "table.csv: this is not a whole HDF5 file"));
    const std::string missing = message_of<InputError>([] { (void)read_particles("/nowhere/to/be/found.csv"); });
    EXPECT_EQ(missing, "/nowhere/to/be/found.csv: the file cannot be read; check its name and permissions");
}

}  // namespace
}  // namespace recoat
