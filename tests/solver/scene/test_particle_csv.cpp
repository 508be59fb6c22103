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

TEST_F(ParticleCsv, NamesTheLineAndColumnOfABadNumber) {
    EXPECT_THAT(refusal("# comment\n" + header + "0,0,0,1,0,0,0,0,0,0\n0,0,zero,1,0,0,0,0,0,0\n"),
                AllOf(HasSubstr("table.csv:4: z: \"zero\""), HasSubstr("SI values")));
    EXPECT_THAT(refusal(header + "0,0,nan,1,0,0,0,0,0,0\n"), HasSubstr(":2: z"));
    EXPECT_THAT(refusal(header + "0,0,50 um,1,0,0,0,0,0,0\n"), HasSubstr("without units"));
}

TEST_F(ParticleCsv, RefusesAWrongNumberOfValues) {
    EXPECT_THAT(refusal(header + "0,0,0,1,0,0,0,0,0\n"), AllOf(HasSubstr(":2:"), HasSubstr("fewer than 10")));
    EXPECT_THAT(refusal(header + "0,0,0,1,0,0,0,0,0,0,0\n"), AllOf(HasSubstr(":2:"), HasSubstr("more than 10")));
}

TEST_F(ParticleCsv, RefusesAnImpossibleRadius) {
    EXPECT_THAT(refusal(header + "0,0,0,0,0,0,0,0,0,0\n"), HasSubstr(":2: radius"));
    EXPECT_THAT(refusal(header + "0,0,0,-1,0,0,0,0,0,0\n"), HasSubstr(":2: radius"));
}

TEST_F(ParticleCsv, WantsTheHeaderAndAParticle) {
    EXPECT_THAT(refusal("0,0,0,1,0,0,0,0,0,0\n"), HasSubstr("x,y,z,radius,vx,vy,vz,wx,wy,wz"));
    EXPECT_THAT(refusal(""), HasSubstr("header"));
    EXPECT_THAT(refusal(header), HasSubstr("no particles"));
}

TEST_F(ParticleCsv, NamesAMissingFile) {
    EXPECT_THAT(testing::message_of<InputError>([] { read_particle_csv("nowhere.csv"); }), HasSubstr("nowhere.csv"));
}

}  // namespace
}  // namespace recoat
