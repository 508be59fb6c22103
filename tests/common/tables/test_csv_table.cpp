#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/error.hpp"
#include "common/tables/csv_table.hpp"
#include "tests/support/throws_message.hpp"

namespace recoat {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::message_of;
using ::testing::StartsWith;

CsvTable read(const std::string& text, const CsvOptions& options = {}) {
    return read_csv_table("t.csv", text, options);
}

std::string refusal(const std::string& text, const CsvOptions& options = {}) {
    return message_of<InputError>([&] { (void)read(text, options); });
}

/// Every way to write the particle (1.5, 2, 3) of radius 0.5.
class Dialect : public ::testing::TestWithParam<const char*> {};

TEST_P(Dialect, HoldsTheParticle) {
    const CsvTable table = read(GetParam());
    EXPECT_THAT(table.position, ElementsAre(Vec3{1.5, 2, 3}));
    EXPECT_THAT(table.radius, ElementsAre(0.5));
    EXPECT_TRUE(table.warnings.empty());
}

INSTANTIATE_TEST_SUITE_P(Separators, Dialect,
                         ::testing::Values("x,y,z,radius\n1.5,2,3,0.5\n", "x;y;z;radius\n1.5;2;3;0.5\n",
                                           "x|y|z|radius\n1.5|2|3|0.5\n", "x y z radius\n1.5\t2 3   0.5\n",
                                           "x\ty\tz\tradius\n1.5 2 3 0.5\n",
                                           "Position X\tPosition Y\tPosition Z\tRadius\n1.5\t2\t3\t0.5\n",
                                           "x, y, z, radius\n1.5 2 3 0.5\n", "sep=;\nx;y;z;radius\n1.5;2;3;0.5\n",
                                           "\"sep=|\"\r\nx|y|z|radius\r\n1.5|2|3|0.5\r\n",
                                           "SEP=\t\nx\ty\tz\tradius\n1.5\t2\t3\t0.5\n"));
INSTANTIATE_TEST_SUITE_P(DecimalCommas, Dialect,
                         ::testing::Values("x;y;z;radius\n1,5;2;3;0,5\n", "x;y;z;radius\n15e-1;2;3,0;,5\n",
                                           "x y z radius\n1,5 2 3 0,5\n", "x\ty\tz\tradius\n1,5\t2\t3\t5e-1\n",
                                           "\"x\",\"y\",\"z\",\"radius\"\n\"1,5\",\"2\",\"3\",\"0,5\"\n",
                                           "name;x;y;z;radius\na.b;1,5;2;3;0,5\n"));
INSTANTIATE_TEST_SUITE_P(Comments, Dialect,
                         ::testing::Values("# from my code\n% units SI\n\nx,y,z,radius\n1.5,2,3,0.5\n",
                                           "# x y z radius\n# layer 7\n1.5 2 3 0.5\n",
                                           "# layer 7\n# x y z radius\n1.5 2 3 0.5\n", "## x,y,z,radius\n1.5,2,3,0.5\n",
                                           "x,y,z,radius\n# first\n1.5,2,3,0.5\n#last\n",
                                           "x y z radius\n1.5 2 3 0.5 # a grain\n",
                                           "# a, b; c\nx,y,z,radius\n1.5,2,3,0.5\n"));
INSTANTIATE_TEST_SUITE_P(Rows, Dialect,
                         ::testing::Values("\"x\",\"y\",\"z\",\"radius\"\n\"1.5\",\"2\",\"3\",\"0.5\"\n",
                                           "x,y,z,radius,\n1.5,2,3,0.5,\n", "x,y,z,radius\n1.5,2,3,0.5,,\n",
                                           "x;y;z;radius;;\n1.5;2;3;0.5;;\n", "x,y,z,radius\n1.5,2,3,0.5\n,,,\n",
                                           "x,y,z,radius\n,,,\n\n1.5,2,3,0.5\n"));
INSTANTIATE_TEST_SUITE_P(Units, Dialect,
                         ::testing::Values("x,y,z,radius\nm,m,m,m\n1.5,2,3,0.5\n",
                                           "x;y;z;radius\n[mm];[mm];[mm];[mm]\n1500;2000;3000;500\n",
                                           "id,x,y,z,radius\n-,cm,cm,cm,cm\n1,150,200,300,50\n",
                                           "# x y z radius\n# mm mm mm mm\n1500 2000 3000 500\n",
                                           "x [mm],y (m),z [cm],Diameter (mm)\n1500,2,300,1000\n",
                                           "x [mm] y [mm] z [mm] d [mm]\n1500 2000 3000 1000\n",
                                           "x [\u00B5m],y [\u03BCm],z [um],d (micron)\n1.5e6,2e6,3e6,1e6\n",
                                           "x [\xB5m];y [\xB5m];z [\xB5m];r [\xB5m]\r\n1.5e6;2e6;3e6;5e5\r\n",
                                           "x,y,z,r\n\xB5m,\xB5m,\xB5m,\xB5m\n1.5e6,2e6,3e6,5e5\n"));
INSTANTIATE_TEST_SUITE_P(
    Names, Dialect,
    ::testing::Values(
        "Particle ID,Position X (m),Position Y (m),Position Z (m),Radius (m),Mass (kg)\n1,1.5,2,3,0.5,9\n",
        "Particle X-Coordinate [m],Particle Y-Coordinate [m],Particle Z-Coordinate [m],Particle Size [m]\n1.5,2,3,1\n",
        "Position[X] (m),Position[Y] (m),Position[Z] (m),Particle Diameter (m)\n1.5,2,3,1\n",
        "\"Points:0\",\"Points:1\",\"Points:2\",Radius\n1.5,2,3,0.5\n", "pos.x,pos.y,pos.z,rad\n1.5,2,3,0.5\n",
        "particle-x-position,particle-y-position,particle-z-position,particle-diameter\n1.5,2,3,1\n",
        ",x,y,z,radius\n0,1.5,2,3,0.5\n", "\xEF\xBB\xBFX, Y, Z, Radius\n1.5,2,3,0.5\n"));

TEST(CsvTable, NamesAsTheyStandOrWithoutUnitAreChosen) {
    const std::string text = "East (mm),North (mm),Up (mm),Grain size (mm)\n1,2,3,4\n";
    for (const bool whole : {true, false}) {
        const std::string unit = whole ? " (MM)" : "";
        const CsvTable table = read(text, {.columns = {.x = "east" + unit,
                                                       .y = "North" + unit,
                                                       .z = "Up" + unit,
                                                       .radius = {},
                                                       .diameter = "Grain Size" + unit,
                                                       .type = {}}});
        EXPECT_THAT(table.position, ElementsAre(Vec3{1e-3, 2e-3, 3e-3}));
        EXPECT_THAT(table.radius, ElementsAre(2e-3));
        EXPECT_TRUE(table.has_units);
    }
    // Brackets without a unit belong to the name.
    const CsvTable plain =
        read("x,y,z,radius (mean)\n1,2,3,4\n",
             {.columns = {.x = {}, .y = {}, .z = {}, .radius = "radius (mean)", .diameter = {}, .type = {}}});
    EXPECT_THAT(plain.radius, ElementsAre(4));
    EXPECT_FALSE(plain.has_units);
}

TEST(CsvTable, VelocitiesHaveUnitsOfTheirOwn) {
    const CsvTable table =
        read("x [um],y [um],z [um],r [um],vx [mm/s],vy [mm/s],vz [mm/s],wx,wy,wz\n1,2,3,4,5,6,nan,8,9,10\n");
    EXPECT_DOUBLE_EQ(table.velocity[0].x, 5e-3);
    EXPECT_TRUE(std::isnan(table.velocity[0].z));
    EXPECT_EQ(table.angular_velocity[0], (Vec3{8, 9, 10}));
}

TEST(CsvTable, WhatIsWrongWithUnitsIsSaid) {
    EXPECT_EQ(
        refusal("x [mm],y [mm],z [mm],radius\n1,2,3,4\n"),
        "t.csv:1: the column \"radius\" names no unit, but \"x [mm]\" does; name the unit of every length, or of none");
    EXPECT_EQ(refusal("x [mm],y [mm],z [mm],radius [furlong]\n1,2,3,4\n"),
              "t.csv:1: the unit of the column \"radius [furlong]\" is none of a length: \"furlong\" is no unit of a "
              "length; use one of m, cm, mm, um, nm");
    EXPECT_THAT(refusal("x,y,z,r [mm/s]\n1,2,3,4\n"),
                HasSubstr("\"mm/s\" is the unit of a speed, but a length is wanted"));
    EXPECT_THAT(refusal("x,y,z,r\nmm,mm,mm,\n1,2,3,4\n"), HasSubstr("\"r\" names no unit"));
    EXPECT_THAT(refusal("x [mm],x [cm],y,z,r\n1,2,3,4,5\n"),
                HasSubstr("there is no column \"x\" among those of the file (x [mm], x [cm], y"));
}

TEST(CsvTable, ColumnsThatAreNotThereAreNamedAndThoseThatAre) {
    EXPECT_EQ(
        refusal("x,y,height,radius\n1,2,3,4\n"),
        "t.csv:1: there is no column \"z\" among those of the file (x, y, height, radius); name it in the first line");
    EXPECT_EQ(refusal("x,y,z,volume\n1,2,3,4\n"),
              "t.csv:1: there is no column \"radius\" or \"diameter\" among those of the file (x, y, z, volume); name "
              "it in the first line");
    EXPECT_EQ(read("x,y,z,volume\n1,2,3,4\n", {.needs_size = false}).radius.size(), 0U);
    EXPECT_THAT(refusal("1,2,3,0.5\n4,5,6,0.5\n"),
                StartsWith("t.csv:1: the rows begin here, but no line names the columns"));
    EXPECT_THAT(refusal("# layer\n1 2 3 0.5\n"), StartsWith("t.csv:2: the rows begin here, but no line names"));
    EXPECT_THAT(refusal("# layer\n"), HasSubstr("no line names the columns"));
    EXPECT_THAT(refusal("x,y,z,r,vx,vy\n1,2,3,4,5,6\n", {.whole_velocities = true}),
                HasSubstr("\"vx\" is one component of a velocity, but not all three are there"));
    EXPECT_THAT(read("x,y,z,r,vx,vy\n1,2,3,4,5,6\n").unused, ElementsAre("vx", "vy"));
}

TEST(CsvTable, DecimalsAreWrittenOneWay) {
    EXPECT_THAT(refusal("x;y;z;r\n1,5;2;3;4\n1.5;2;3;4\n"),
                AllOf(StartsWith("t.csv:3: column 1 (x): \"1.5\""), HasSubstr("decimal comma, as those before")));
    EXPECT_THAT(refusal("x;y;z;r\n1.5;2;3;4\n1;2,5;3;4\n"),
                AllOf(StartsWith("t.csv:3: column 2 (y): \"2,5\""), HasSubstr("decimal point")));
    EXPECT_THAT(refusal("x;y;z;r\n1.234,5;2;3;4\n"), StartsWith("t.csv:2: column 1 (x): \"1.234,5\""));
    EXPECT_THAT(refusal("x,y,z,r\n1,5,2,5,3,5,4,5\n"), HasSubstr("decimal commas need semicolons"));
}

TEST(CsvTable, ALastLineWithoutEndIsSaid) {
    const CsvTable table = read("x,y,z,r\n1,2,3,4");
    EXPECT_THAT(table.position, ElementsAre(Vec3{1, 2, 3}));
    EXPECT_THAT(table.warnings, ElementsAre(StartsWith("t.csv:2: the last line has no line end")));
    EXPECT_TRUE(read("x,y,z,r\n1,2,3,4\n  ").warnings.empty());
}

TEST(CsvTable, IdentitiesKeepSixtyFourBits) {
    const CsvTable table = read("id,x,y,z,r\n1152921504606846977,1,2,3,4\n-9223372036854775808,1,2,3,4\n7.0,1,2,3,4\n");
    EXPECT_THAT(table.id, ElementsAre(1152921504606846977, std::numeric_limits<std::int64_t>::min(), 7));
    for (const char* id : {"9223372036854775808", "1e300", "1.5"}) {
        EXPECT_THAT(refusal(std::string("id,x,y,z,r\n") + id + ",1,2,3,4\n"), HasSubstr("no whole number of 64 bits"));
    }
}

}  // namespace
}  // namespace recoat
