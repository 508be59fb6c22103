#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/error.hpp"
#include "common/output_file.hpp"
#include "solver/scene/particle_csv.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/throws_message.hpp"

namespace recoat {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const std::string header = "x,y,z,radius,vx,vy,vz,wx,wy,wz\n";

class ParticleCsv : public ::testing::Test {
protected:
    ParticleTable read(const std::string& text) {
        write_text_file(folder_ / "table.csv", text);
        return read_particle_csv(folder_ / "table.csv");
    }
    std::string refusal(const std::string& text) {
        return testing::message_of<InputError>([&] { read(text); });
    }

private:
    testing::TemporaryFolder folder_;
};

TEST_F(ParticleCsv, ReadsEveryColumn) {
    const ParticleTable table = read("# two\n" + header + "1,2,3,0.5,4,5,6,7,8,9\n\n 1e-3 , .5,-2.,1,0,0,0,0,0,-1\r\n");
    ASSERT_EQ(table.size(), 2U);
    EXPECT_EQ(table.position[0], (Vec3{1, 2, 3}));
    EXPECT_EQ(table.velocity[0], (Vec3{4, 5, 6}));
    EXPECT_EQ(table.angular_velocity[0], (Vec3{7, 8, 9}));
    EXPECT_EQ(table.radius[0], 0.5);
    EXPECT_EQ(table.position[1], (Vec3{1e-3, 0.5, -2}));
    EXPECT_EQ(table.angular_velocity[1], (Vec3{0, 0, -1}));
}

TEST_F(ParticleCsv, ColumnsInAnyOrderWithUnitsAndWithoutVelocities) {
    for (const char* text : {"x,y,z,radius\n1,2,3,0.5\n", "Radius (mm);z [m];y [m];x [m]\n500;3;2;1\n",
                             "\xEF\xBB\xBFid x y z d\r\n7 1 2 3 1\r\n", "x;y;z;radius\n1,0;2;3;0,5\n"}) {
        const ParticleTable table = read(text);
        ASSERT_EQ(table.size(), 1U) << text;
        EXPECT_EQ(table.position[0], (Vec3{1, 2, 3})) << text;
        EXPECT_EQ(table.radius[0], 0.5) << text;
        EXPECT_EQ(table.velocity, std::vector<Vec3>(1)) << text;
        EXPECT_EQ(table.angular_velocity, std::vector<Vec3>(1)) << text;
    }
    EXPECT_EQ(read("x [um],y [um],z [um],radius [um],vx,vy,vz\n1,2,3,4,5,6,7\n").velocity[0], (Vec3{5, 6, 7}));
}

TEST_F(ParticleCsv, NamesTheLineAndColumnOfABadNumber) {
    EXPECT_THAT(refusal("# comment\n" + header + "0,0,0,1,0,0,0,0,0,0\n0,0,zero,1,0,0,0,0,0,0\n"),
                HasSubstr("table.csv:4: column 3 (z): \"zero\": this is no number"));
    EXPECT_THAT(refusal(header + "0,0,nan,1,0,0,0,0,0,0\n"), HasSubstr(":2: column 3 (z)"));
    EXPECT_THAT(refusal(header + "0,0,50 um,1,0,0,0,0,0,0\n"), HasSubstr("\"50 um\": this is no number"));
    EXPECT_THAT(refusal(header + "0,0,0,1,0,nan,0,0,0,0\n"), HasSubstr(":2: the velocity is (0, nan, 0)"));
}

TEST_F(ParticleCsv, RefusesAWrongNumberOfValues) {
    EXPECT_THAT(refusal(header + "0,0,0,1,0,0,0,0,0\n"),
                HasSubstr(":2: the line has 9 columns, the first line names 10"));
    EXPECT_THAT(refusal(header + "0,0,0,1,0,0,0,0,0,0,0\n"), HasSubstr(":2: the line has 11 columns"));
    EXPECT_THAT(refusal("x,y,z,radius,vx\n0,0,0,1,0\n"), HasSubstr("\"vx\" is one component of a velocity"));
}

TEST_F(ParticleCsv, RefusesAnImpossibleRadius) {
    EXPECT_THAT(refusal(header + "0,0,0,0,0,0,0,0,0,0\n"), HasSubstr(":2: column 4 (radius)"));
    EXPECT_THAT(refusal(header + "0,0,0,-1,0,0,0,0,0,0\n"), HasSubstr(":2: column 4 (radius)"));
}

TEST_F(ParticleCsv, WantsTheHeaderAndAParticle) {
    EXPECT_THAT(refusal("0,0,0,1,0,0,0,0,0,0\n"), HasSubstr("no line names the columns"));
    EXPECT_THAT(refusal(""), HasSubstr("no lines of text"));
    EXPECT_THAT(refusal(header), HasSubstr("no particles"));
    EXPECT_THAT(refusal("x,y,z\n0,0,0\n"), HasSubstr("no column \"radius\" or \"diameter\""));
}

TEST_F(ParticleCsv, SaysWhatItPassesOver) {
    ::testing::internal::CaptureStderr();
    (void)read("id,x,y,z,radius,density\n1,1,2,3,1,4430");
    EXPECT_THAT(::testing::internal::GetCapturedStderr(),
                AllOf(HasSubstr("recoat-solve: warning: "), HasSubstr("passed over: density"),
                      HasSubstr(":2: the last line has no line end")));
}

TEST_F(ParticleCsv, NamesAMissingFile) {
    EXPECT_THAT(testing::message_of<InputError>([] { read_particle_csv("nowhere.csv"); }), HasSubstr("nowhere.csv"));
    EXPECT_THAT(refusal(std::string("\xFF\xFEx\0,\0y\0,\0z\0", 12)),
                HasSubstr("table.csv: the file is text in UTF-16"));
}

}  // namespace
}  // namespace recoat
