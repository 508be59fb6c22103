#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/error.hpp"
#include "common/output_file.hpp"
#include "solver/scene/initial_particles.hpp"
#include "solver/scene/read_scene.hpp"
#include "tests/support/scene_text.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/throws_message.hpp"

namespace recoat {
namespace {

using ::testing::HasSubstr;

class InitialParticles : public ::testing::Test {
protected:
    Scene load(const std::string& rows, const std::vector<std::string>& settings = {}) {
        write_text_file(folder_ / "table.csv", "x,y,z,radius,vx,vy,vz,wx,wy,wz\n" + rows);
        write_text_file(folder_ / "scene.yaml",
                        "scene: particles\nparticles: table.csv\nduration: 1 ms\n"
                        "stiffness_ratio: 0.001\n" +
                            testing::model_text);
        return load_scene(folder_ / "scene.yaml", settings);
    }
    testing::TemporaryFolder folder_;
};

// A step of 20 ns: 0.05 rad are 2.5e6 rad/s. Kinetic energies beyond it end in infinity.
TEST_F(InitialParticles, SpinsThatCannotBeFollowedAreRefused) {
    EXPECT_EQ(initial_particles(load("0,0,0,25e-6,0,0,0,0,2.4e6,0\n")).size(), 1U);
    const std::string rows = "0,0,0,25e-6,0,0,0,0,0,0\n1,0,0,25e-6,0,0,0,0,2.6e6,0\n";
    EXPECT_THAT(testing::message_of<InputError>([&] { load(rows); }), HasSubstr("particle 1 spins too fast"));
    EXPECT_THAT(testing::message_of<InputError>([&] { load("0,0,0,25e-6,0,0,0,1e300,0,0\n"); }), HasSubstr("spins"));
}

// The stability limit falls with the diameter; a table may hold smaller spheres than d_p.
TEST_F(InitialParticles, TheTimeStepMustDoForTheSmallest) {
    const std::vector<std::string> step = {"time_step=1e-6 s"};
    EXPECT_EQ(load("0,0,0,25e-6,0,0,0,0,0,0\n", step).smallest_diameter, 50e-6);
    const std::string rows = "0,0,0,25e-6,0,0,0,0,0,0\n1,0,0,2.5e-6,0,0,0,0,0,0\n";
    EXPECT_THAT(testing::message_of<InputError>([&] { load(rows, step); }), HasSubstr("stability limit"));
    EXPECT_EQ(load(rows).smallest_diameter, 5e-6);
}

}  // namespace
}  // namespace recoat
