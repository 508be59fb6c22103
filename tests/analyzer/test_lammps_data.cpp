#include "tests/analyzer/reader_fixture.hpp"

namespace recoat {
namespace {

using testing::begins;
using testing::replaced;

const std::string small =
    "LAMMPS data file\n\n2 atoms\n1 atom types\n\n0 4 xlo xhi\n0 2 ylo yhi\n0 3 zlo zhi\n\nMasses\n\n1 1.0\n\n"
    "Atoms # sphere\n\n1 1 0.5 2500 1 1 1 0 -1 0\n2 1 1 2500 2 1 1 0 0 0\n\nVelocities\n\n2 1 2 3 0 0 4\n1 0 0 -1 0 5 "
    "0\n";

class LammpsData : public testing::ReaderTest {};

TEST_F(LammpsData, AtomsBoxAndDensity) {
    const Source source = read(small);
    EXPECT_EQ(source.format, "lammps-data");
    EXPECT_EQ(source.position, (std::vector<Vec3>{{1, 1, 1}, {2, 1, 1}}));
    EXPECT_EQ(source.radius, (std::vector<double>{0.25, 0.5}));
    EXPECT_EQ(source.info.density, 2500);
    EXPECT_EQ(source.velocity, (std::vector<Vec3>{{0, 0, -1}, {1, 2, 3}}));
    EXPECT_EQ(source.angular_velocity, (std::vector<Vec3>{{0, 5, 0}, {0, 0, 4}}));
    ASSERT_TRUE(source.box);
    EXPECT_EQ(source.box->upper, (Vec3{4, 2, 3}));
    // Only the image flag of y is not zero anywhere.
    EXPECT_EQ(source.box->periodic, (std::array{false, true, false}));
}

TEST_F(LammpsData, TheStyleIsToldNotGuessed) {
    const std::string untold = replaced(small, " # sphere", "");
    EXPECT_TRUE(begins(error(untold), "layer:14: the file does not say its atom style"));
    ReadOptions options;
    options.atom_style = "sphere";
    EXPECT_EQ(read(untold, options).radius[1], 0.5);
    EXPECT_EQ(read(small, options).radius[1], 0.5);
    options.atom_style = "atomic";
    EXPECT_TRUE(begins(error(small, options), "layer:14: the file says itself that its atom style is \"sphere\""));
    EXPECT_TRUE(begins(error(untold, options), "layer:16: the line has 10 columns, but atoms of style atomic"));
    options.atom_style = "sphear";
    EXPECT_TRUE(begins(error(untold, options), "layer:14: the atom style \"sphear\" is not known"));
    EXPECT_TRUE(
        begins(error(replaced(small, "# sphere", "# hybrid sphere")), "layer:14: the atom style \"hybrid sphe"));
    const std::string bonded = replaced(replaced(replaced(small, "1 1 0.5 2500 1 1 1 0 -1 0", "1 9 1 0.5 2500 1 1 1"),
                                                 "2 1 1 2500 2 1 1 0 0 0", "2 9 1 1 2500 2 1 1"),
                                        "# sphere", "# bpm/sphere");
    EXPECT_EQ(read(bonded).radius, (std::vector<double>{0.25, 0.5}));
    const std::string atomic = replaced(
        replaced(replaced(small, "1 1 0.5 2500 1 1 1 0 -1 0", "1 1 1 1 1"), "2 1 1 2500 2 1 1 0 0 0", "2 1 2 1 1"),
        "# sphere", "# atomic");
    EXPECT_TRUE(begins(error(atomic), "layer: the file gives no size of its particles"));
    EXPECT_EQ(read(atomic, {.columns = {}, .length_unit = {}, .radius = 0.5}).position[1], (Vec3{2, 1, 1}));
}

TEST_F(LammpsData, CommentsAreNoContent) {
    std::string text = replaced(small, "2 atoms", "2 atoms  # all grains");
    text = replaced(text, "0 3 zlo zhi", "  \t \n0 3 zlo zhi # open above");
    text = replaced(text, "Atoms # sphere", "# what follows\n  Atoms   # sphere");
    text = replaced(text, "1 1 1 0 -1 0", "1 1 1 0 -1 0 # a grain\n# another\n");
    text = replaced(text, "Velocities\n\n", "# and how fast\nVelocities # m/s\n\n# those that fall\n\n");
    text = replaced(text, "2 1 2 3 0 0 4", "2 1 2 3 0 0 4#fast\n  # the other\n");
    const Source source = read(text);
    EXPECT_EQ(source.position, (std::vector<Vec3>{{1, 1, 1}, {2, 1, 1}}));
    EXPECT_EQ(source.velocity, (std::vector<Vec3>{{0, 0, -1}, {1, 2, 3}}));
    EXPECT_EQ(source.box->upper, (Vec3{4, 2, 3}));
}

TEST_F(LammpsData, BoxesThatAreNotTilted) {
    for (const char* tilts : {"0 0 0 xy xz yz", "0.0 -0.0 0e0 xy xz yz", "1e-16 0 0 xy xz yz"}) {
        EXPECT_EQ(read(replaced(small, "zlo zhi\n", "zlo zhi\n" + std::string(tilts) + "\n")).box->upper,
                  (Vec3{4, 2, 3}));
    }
    const std::string edges = "4 0 0 avec\n0 2 0 bvec\n0 0 3 cvec\n-1 0 0 abc origin\n";
    const std::string general = replaced(small, "0 4 xlo xhi\n0 2 ylo yhi\n0 3 zlo zhi\n", edges);
    EXPECT_EQ(read(general).box->lower, (Vec3{-1, 0, 0}));
    EXPECT_EQ(read(general).box->upper, (Vec3{3, 2, 3}));
    EXPECT_TRUE(begins(error(replaced(general, "0 2 0 bvec", "0.1 2 0 bvec")), "layer:7: the box is triclinic"));
    EXPECT_TRUE(
        begins(error(replaced(small, "zlo zhi\n", "zlo zhi\n0 0 1e-4 xy xz yz\n")), "layer:9: the box is triclinic"));
}

TEST_F(LammpsData, FilesThatEndInsideALine) {
    for (const std::size_t cut : {1U, 2U}) {
        EXPECT_TRUE(begins(error(small.substr(0, small.size() - cut)), "layer:22: "));
    }
    const std::string atoms = small.substr(0, small.find("\n\nVelocities"));
    EXPECT_TRUE(begins(error(atoms), "layer:17: the file ends inside this line"));
    EXPECT_EQ(read(atoms + "\n").position.size(), 2U);
    EXPECT_TRUE(begins(error(small + "\nBonds\n\n1 1 1"), "layer:26: the file ends inside this line"));
}

TEST_F(LammpsData, RealFile) {
    const Source source = read_particles(data("lammps-write_data.data"));
    ASSERT_EQ(source.position.size(), 100U);
    EXPECT_EQ(source.id[0], 2455);
    EXPECT_EQ(source.position[0], (Vec3{0.0008969776621513286, 1.5221851286980524e-05, 2.4999691061534087e-05}));
    EXPECT_EQ(source.radius[99], 2.5e-5);
    EXPECT_EQ(source.info.density, 4430);
    EXPECT_TRUE(source.box->periodic[1]);
}

TEST_F(LammpsData, Velocities) {
    const std::string none = small.substr(0, small.find("Velocities"));
    EXPECT_TRUE(read(none).velocity.empty());
    const Source plain = read(none + "Velocities\n\n1 1 2 3\n2 4 5 6\n");
    EXPECT_EQ(plain.velocity, (std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}}));
    EXPECT_TRUE(plain.angular_velocity.empty());
    const auto with = [&](const std::string& lines) { return error(none + "Velocities\n\n" + lines); };
    EXPECT_TRUE(begins(with("1 1 2 3\n"), "layer:21: the section Velocities ends after 1 of 2 atoms"));
    EXPECT_TRUE(begins(with("1 1 2 3\n1 1 2 3\n"), "layer:22: the section Velocities gives a velocity to the atom 1"));
    EXPECT_TRUE(begins(with("1 1 2 3\n7 1 2 3\n"), "layer:22: the section Velocities gives a velocity to the atom 7"));
    EXPECT_TRUE(begins(with("1 1 2\n2 1 2 3\n"), "layer:21: the line has 3 columns, but those of the section"));
    EXPECT_TRUE(begins(with("1 1 2 three\n2 1 2 3\n"), "layer:21: column 4 (vz): \"three\": this is no number"));
}

TEST_F(LammpsData, DamagedFiles) {
    const std::string atom = "1 1 0.5 2500 1 1 1 0 -1 0\n";
    const auto with = [&](const std::string& line) { return error(replaced(small, atom, line)); };
    EXPECT_TRUE(begins(error(replaced(small, "2 atoms", "3 atoms")), "layer:19: the section Atoms ends after 2 of 3"));
    EXPECT_TRUE(
        begins(error(small.substr(0, small.find("2 1 1 2500"))), "layer:16: the section Atoms ends after 1 of 2"));
    EXPECT_TRUE(begins(error(small.substr(0, small.find("Atoms"))), "layer:13: there is no section Atoms"));
    EXPECT_TRUE(begins(with("1 1 0.5 2500 1 1\n"), "layer:16: the line has 6 columns, but atoms of style sphere"));
    EXPECT_TRUE(begins(with("1 1 0.5 2500 1 1 1\n"), "layer:17: the line has 10 columns, but atoms of style sphere"));
    EXPECT_TRUE(
        begins(with("1 1 0.5 2500 1 inf 1 0 0 0\n"), "layer:16: column 6 (y): \"inf\": the number is not finite"));
    EXPECT_TRUE(begins(with("1 1 0 2500 1 1 1 0 0 0\n"), "layer:16: column 3 (diameter): \"0\": a particle must have"));
    EXPECT_TRUE(begins(with("2 1 0.5 2500 1 1 1 0 0 0\n"), "layer:17: the id 2 has been given to another particle"));
    EXPECT_TRUE(begins(with("1 1 0.5 2500 1 1 7 0 0 0\n"), "layer:16: the particle lies at z = 7 m, outside the box"));
}

}  // namespace
}  // namespace recoat
