/// Velocities of foreign files, by their usual names and in their own units.

#include <cmath>

#include "common/state.hpp"
#include "tests/analyzer/reader_fixture.hpp"

namespace recoat {
namespace {

using testing::begins;
using testing::replaced;

const std::string dump =
    "ITEM: UNITS\nmicro\nITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff ff\n0 9\n0 9\n0 9\n"
    "ITEM: ATOMS id x y z radius vz vx vy omegax omegay omegaz\n1 1 2 3 0.5 30 10 20 1 2 3\n";

class Velocities : public testing::ReaderTest {
protected:
    static void expect_near(const std::vector<Vec3>& found, Vec3 wanted) {
        ASSERT_EQ(found.size(), 1U);
        EXPECT_NEAR(norm(found[0] - wanted), 0, 1e-12 * norm(wanted));
    }
};

TEST_F(Velocities, OfTables) {
    const Source source = read("x,y,z,r,vx,vy,vz,omega_x,omega_y,omega_z\n1,2,3,1,4,5,6,7,8,9\n");
    EXPECT_EQ(source.velocity, (std::vector<Vec3>{{4, 5, 6}}));
    EXPECT_EQ(source.angular_velocity, (std::vector<Vec3>{{7, 8, 9}}));
    const Source paraview = read(
        "\"Points:0\" \"Points:1\" \"Points:2\" r \"Velocity:0\" \"Velocity:1\" \"Velocity:2\"\n"
        "1 2 3 1 4 5 6\n");
    EXPECT_EQ(paraview.velocity, (std::vector<Vec3>{{4, 5, 6}}));
    expect_near(read("x [mm],y [m],z [m],r [m],vx [mm/s],vy [m/s],vz\n1,2,3,1,4,5,6\n").velocity, {4e-3, 5, 6});
    // Two of three are none.
    EXPECT_TRUE(read("x,y,z,r,vx,vy\n1,2,3,1,4,5\n").velocity.empty());
    EXPECT_TRUE(
        begins(error("x [m/s],y,z,r\n1,2,3,1\n"), "layer:1: the unit of the column \"x [m/s]\" is none of a length"));
    const Source unknown = read("x,y,z,r,vx,vy,vz,omegax,omegay,omegaz\n1,2,3,1,4,nan,6,7,8,9\n");
    EXPECT_TRUE(unknown.velocity.empty());
    EXPECT_EQ(unknown.angular_velocity.size(), 1U);
    ASSERT_EQ(unknown.warnings.size(), 1U);
    EXPECT_TRUE(
        unknown.warnings[0].ends_with("layer:2: the velocity of this particle is not finite; it is left out for all"));
}

TEST_F(Velocities, OfDumpsInTheirUnits) {
    const Source micro = read(dump);  // um/us is m/s
    expect_near(micro.velocity, {10, 20, 30});
    expect_near(micro.angular_velocity, {1e6, 2e6, 3e6});
    expect_near(read(replaced(dump, "micro", "cgs")).velocity, {0.1, 0.2, 0.3});
    expect_near(read(replaced(dump, "micro", "metal")).velocity, {1e3, 2e3, 3e3});
    const std::string plain = replaced(dump, "ITEM: UNITS\nmicro\n", "");
    expect_near(read(plain).velocity, {10, 20, 30});
    expect_near(read(plain, {.columns = {}, .length_unit = 1e-3}).velocity, {1e-2, 2e-2, 3e-2});
    expect_near(read(plain, {.columns = {}, .length_unit = 1e-3}).angular_velocity, {1, 2, 3});
}

TEST_F(Velocities, UnitsWithoutALength) {
    const std::string text = replaced(dump, "micro", "lj");
    EXPECT_TRUE(begins(error(text), "layer:11: the dump has the units \"lj\", which say no length in metres; give it"));
    const Source source = read(text, {.columns = {}, .length_unit = 1e-6});
    expect_near(source.position, {1e-6, 2e-6, 3e-6});
    EXPECT_TRUE(source.velocity.empty());
}

TEST_F(Velocities, OfMercury) {
    const Source source = read("1 0 0 0 0 4 2 3\n1 1 1 4 5 6 0.5 0 0 0 7 8 9 0\n");
    EXPECT_EQ(source.velocity, (std::vector<Vec3>{{4, 5, 6}}));
    EXPECT_EQ(source.angular_velocity, (std::vector<Vec3>{{7, 8, 9}}));
}

TEST_F(Velocities, OfVtk) {
    const std::string legacy =
        "# vtk DataFile Version 2.0\nlayer\nASCII\nDATASET POLYDATA\nPOINTS 1 float\n1 2 3\nPOINT_DATA 1\n"
        "SCALARS radius float\nLOOKUP_TABLE default\n1\nVECTORS v float\n4 5 6\nFIELD more 1\nomega 3 1 float\n7 8 9\n";
    EXPECT_EQ(read(legacy).velocity, (std::vector<Vec3>{{4, 5, 6}}));
    EXPECT_EQ(read(legacy).angular_velocity, (std::vector<Vec3>{{7, 8, 9}}));
    const Source unknown = read(replaced(legacy, "4 5 6", "4 inf 6"));
    EXPECT_TRUE(unknown.velocity.empty());
    EXPECT_FALSE(unknown.angular_velocity.empty());
    ASSERT_EQ(unknown.warnings.size(), 1U);
    EXPECT_NE(unknown.warnings[0].find("particle 0: the velocity of this particle is not finite"), std::string::npos);
    for (const auto& [linear, angular] :
         {std::pair("linVelVec", "angVelVec"), std::pair("velocity_lin", "velocity_ang"),
          std::pair("Velocity", "AngularVelocity")}) {
        const std::string array = "<DataArray format=\"ascii\" type=\"Float64\" NumberOfComponents=\"3\" Name=\"";
        const std::string xml =
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"1\"><PointData>" +
            array + linear + "\">4 5 6</DataArray>" + array + angular + "\">7 8 9</DataArray></PointData><Points>" +
            array + "p\">1 2 3</DataArray></Points></Piece></PolyData></VTKFile>\n";
        ReadOptions options;
        options.radius = 1;
        EXPECT_EQ(read(xml, options).velocity, (std::vector<Vec3>{{4, 5, 6}})) << linear;
        EXPECT_EQ(read(xml, options).angular_velocity, (std::vector<Vec3>{{7, 8, 9}})) << angular;
    }
}

TEST_F(Velocities, OfRealFiles) {
    EXPECT_EQ(read_particles(data("yade-spheres.2000.vtu")).velocity.size(), 60U);
    EXPECT_EQ(read_particles(data("liggghts-atom-452000.vtk")).angular_velocity.size(), 60U);
    EXPECT_EQ(read_particles(data("lammps-write_data.data")).velocity[0],
              (Vec3{0.00650560973959287, 0.001506199431579436, -4.917715366113262e-15}));
    EXPECT_TRUE(read_particles(data("yade-text.txt")).velocity.empty());
}

TEST_F(Velocities, OfStates) {
    const testing::TemporaryFolder folder;
    State state;
    state.id = {1};
    state.position = {{1, 2, 3}};
    state.radius = {1};
    state.velocity = {{4, 5, 6}};
    state.angular_velocity = {{std::nan(""), std::nan(""), std::nan("")}};  // as in converted files
    write_state(folder / "one.vtkhdf", {}, state);
    const Source source = read_particles(folder / "one.vtkhdf");
    EXPECT_EQ(source.velocity, state.velocity);
    EXPECT_TRUE(source.angular_velocity.empty());
}

}  // namespace
}  // namespace recoat
