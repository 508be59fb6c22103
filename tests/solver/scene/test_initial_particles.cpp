#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/error.hpp"
#include "common/output_file.hpp"
#include "common/state.hpp"
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

TEST_F(InitialParticles, LengthsInAnotherUnitAreRefused) {
    for (const char* row : {"0,0,0,25,0,0,0,0,0,0\n", "0,0,0,1e-120,0,0,0,0,0,0\n", "0,0,0,1e200,0,0,0,0,0,0\n"})
        EXPECT_THAT(testing::message_of<InputError>([&] { load(row); }), HasSubstr("particle 0 has a radius")) << row;
    for (const char* row : {"1e17,0,0,25e-6,0,0,0,0,0,0\n", "0,-1e300,0,25e-6,0,0,0,0,0,0\n"})
        EXPECT_THAT(testing::message_of<InputError>([&] { load(row); }), HasSubstr("away from the origin")) << row;
    EXPECT_EQ(load("0,0,1e4,25e-6,0,0,0,0,0,0\n").kind, "particles");
}

// 1e30 s used to become a run of no steps at all.
TEST_F(InitialParticles, ARunWithoutEndIsRefused) {
    const std::string row = "0,0,0,25e-6,0,0,0,0,0,0\n";
    EXPECT_THAT(testing::message_of<InputError>([&] { load(row, {"duration=1e30 s"}); }), HasSubstr("duration"));
    EXPECT_EQ(load(row, {"duration=1e6 s"}).stages[0].steps(), 50000000000000);
    EXPECT_EQ(load(row, {"time_step=1e-300 s", "duration=1e-298 s"}).output.energy_interval, 1000000000000000);
}

// The stability limit falls with the diameter; a table may hold smaller spheres than d_p.
TEST_F(InitialParticles, TheTimeStepMustDoForTheSmallest) {
    const std::vector<std::string> step = {"time_step=1e-6 s"};
    EXPECT_EQ(load("0,0,0,25e-6,0,0,0,0,0,0\n", step).smallest_diameter, 50e-6);
    const std::string rows = "0,0,0,25e-6,0,0,0,0,0,0\n1,0,0,2.5e-6,0,0,0,0,0,0\n";
    EXPECT_THAT(testing::message_of<InputError>([&] { load(rows, step); }), HasSubstr("stability limit"));
    EXPECT_EQ(load(rows).smallest_diameter, 5e-6);
}

class StateWithoutVelocities : public ::testing::Test {
protected:
    Scene load(const std::vector<Vec3>& velocity) {
        State state;
        state.id = {0, 1};
        state.position = {{0, 0, 0}, {1e-3, 0, 0}};
        state.radius = {25e-6, 25e-6};
        state.velocity = velocity;
        state.angular_velocity.assign(2, {unknown, unknown, unknown});
        write_state(folder_ / "state.vtkhdf", {}, state);
        write_text_file(folder_ / "scene.yaml",
                        "scene: particles\nstart_from: state.vtkhdf\nduration: 1 ms\n"
                        "stiffness_ratio: 0.001\n" +
                            testing::model_text);
        return load_scene(folder_ / "scene.yaml");
    }
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    testing::TemporaryFolder folder_;
};

TEST_F(StateWithoutVelocities, StartsAtRest) {
    const Scene scene = load({2, {unknown, unknown, unknown}});
    const ParticleTable particles = initial_particles(scene);
    EXPECT_EQ(particles.velocity, std::vector<Vec3>(2));
    EXPECT_EQ(particles.angular_velocity, std::vector<Vec3>(2));
}

TEST_F(StateWithoutVelocities, KeepsThoseThatItHas) {
    const Scene scene = load({{1, 0, 0}, {0, 2, 0}});
    EXPECT_EQ(initial_particles(scene).velocity.at(1), (Vec3{0, 2, 0}));
}

TEST_F(StateWithoutVelocities, IsRefusedWhereOnlySomeAreMissing) {
    EXPECT_THAT(testing::message_of<InputError>([&] {
                    load({{1, 0, 0}, {0, unknown, 0}});
                }),
                HasSubstr("particle 1 has a velocity or angular velocity that is not finite"));
}

}  // namespace
}  // namespace recoat
