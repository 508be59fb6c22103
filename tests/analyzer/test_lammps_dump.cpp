#include "tests/analyzer/reader_fixture.hpp"

namespace recoat {
namespace {

using testing::begins;
using testing::message_of;
using testing::replaced;

const std::string two_snapshots =
    "ITEM: UNITS\nmicro\nITEM: TIME\n0.5\n"
    "ITEM: TIMESTEP\n100\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff pp ff\n-1 3\n0 2\n0 1e1\n"
    "ITEM: ATOMS id type x y z radius\n7 1 1 1 1 0.5\n3 1 2 1 1 0.25\n"
    "ITEM: TIME\n1\n"
    "ITEM: TIMESTEP\n200\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff pp ff\n-1 3\n0 2\n0 1e1\n"
    "ITEM: ATOMS id type xs yu zs diameter\n3 1 0.25 -1.5 0.125 0.5\n";

class LammpsDump : public testing::ReaderTest {};

TEST_F(LammpsDump, TheLastSnapshotInMetres) {
    const Source source = read(two_snapshots);
    EXPECT_EQ(source.format, "lammps-dump");
    ASSERT_EQ(source.position.size(), 1U);
    // xs is scaled by the box, yu lies in another image of it.
    EXPECT_NEAR(source.position[0].x, 0, 1e-20);
    EXPECT_NEAR(source.position[0].y, -1.5e-6, 1e-20);
    EXPECT_NEAR(source.position[0].z, 1.25e-6, 1e-20);
    EXPECT_NEAR(source.radius[0], 0.25e-6, 1e-20);
    EXPECT_EQ(source.id[0], 3);
    ASSERT_TRUE(source.box);
    EXPECT_EQ(source.box->periodic, (std::array{false, true, false}));
    EXPECT_NEAR(source.box->upper.y, 2e-6, 1e-20);
}

TEST_F(LammpsDump, OtherSnapshotsByNumber) {
    ReadOptions options;
    options.step = {StepChoice::Which::first, 0};
    EXPECT_EQ(read(two_snapshots, options).position.size(), 2U);
    options.step = {StepChoice::Which::number, 100};
    EXPECT_EQ(read(two_snapshots, options).id, (std::vector<std::int64_t>{7, 3}));
    options.step.number = 150;
    EXPECT_EQ(error(two_snapshots, options), "layer: there is no time step 150; the file has 2: 100, 200");
}

TEST_F(LammpsDump, UnitAndRadiusByOption) {
    const std::string text =
        "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp ff\n0 4\n0 4\n0 4\n"
        "ITEM: ATOMS id xsu ys z size\n1 0.5 0.25 1 3\n";
    EXPECT_TRUE(begins(error(text), "layer: the file gives no size of its particles"));
    ReadOptions options;
    options.radius = 0.25e-3;
    options.length_unit = 1e-3;
    const Source source = read(text, options);
    EXPECT_NEAR(source.position[0].x, 2e-3, 1e-18);
    EXPECT_NEAR(source.position[0].y, 1e-3, 1e-18);
    EXPECT_EQ(source.radius[0], 0.25e-3);
    options.radius.reset();
    options.columns.diameter = "size";
    EXPECT_NEAR(read(text, options).radius[0], 1.5e-3, 1e-18);
    options.radius = 1;
    EXPECT_EQ(error(text, options), "layer: the file gives the size of its particles; leave the radius out");
    EXPECT_TRUE(begins(error(two_snapshots, {.columns = {}, .length_unit = 1.0}),
                       "layer: the file says itself that its unit of length is 1e-06 m"));
}

TEST_F(LammpsDump, RealFiles) {
    const Source plain = read_particles(data("lammps-custom.dump.gz"));
    const Source scaled = read_particles(data("lammps-scaled.dump"));
    ASSERT_EQ(plain.position.size(), 100U);
    ASSERT_EQ(scaled.position.size(), 100U);
    EXPECT_EQ(plain.id, scaled.id);
    for (std::size_t i = 0; i < plain.position.size(); ++i) {
        // Six digits; the box is 9 mm long.
        EXPECT_NEAR(norm(plain.position[i] - scaled.position[i]), 0, 1e-8) << i;
    }
    EXPECT_EQ(plain.position[0], (Vec3{0.00089437, 1.46181e-05, 2.49997e-05}));
    EXPECT_EQ(plain.radius[99], 2.5e-5);
}

TEST_F(LammpsDump, WhatIsNoListOfParticles) {
    const std::string contacts = message_of<InputError>([] { (void)read_particles(data("lammps-contacts.dump")); });
    EXPECT_NE(contacts.find("lammps-contacts.dump: this dump lists entries (local entries such as contacts"),
              contacts.npos);
    EXPECT_TRUE(begins(error(replaced(two_snapshots, "BOUNDS ff pp ff", "BOUNDS xy xz yz ff pp ff")),
                       "layer:10: the line has 2 numbers, but the bounds of this box along one direction are 3"));
    EXPECT_TRUE(begins(error("ITEM: TIMESTEP\n0\nITEM: ATOMS x y z\n"),
                       "layer:3: there is no \"ITEM: NUMBER OF ATOMS\" before the atoms"));
    EXPECT_TRUE(begins(error("ITEM: NONSENSE\n"), "layer:1: \"ITEM: NONSENSE\" is no item"));
}

TEST_F(LammpsDump, BoxesThatAreNotTilted) {
    const auto with = [&](const std::string& flags, const std::string& bounds) {
        return replaced(two_snapshots, "ff pp ff\n-1 3\n0 2\n0 1e1\n", flags + "\n" + bounds);
    };
    ReadOptions first;
    first.step.which = StepChoice::Which::first;
    const std::string zeros = "-1 3 0.0000000000000000e+00\n0 2 -0\n0 1e1 0\n";
    for (const std::string& text :
         {with("xy xz yz ff pp ff", zeros), with("abc origin ff pp ff", "4 0 0 -1\n0 2 0 0\n0 0 10 0\n")}) {
        const Source source = read(text, first);
        EXPECT_EQ(source.box->periodic, (std::array{false, true, false}));
        EXPECT_NEAR(source.box->lower.x, -1e-6, 1e-20);
        EXPECT_NEAR(source.box->upper.x, 3e-6, 1e-20);
    }
    EXPECT_TRUE(
        begins(error(with("xy xz yz ff pp ff", replaced(zeros, "-1 3 0.0000000000000000e+00", "-1 3 1e-4")), first),
               "layer:10: the box is triclinic (tilted)"));
    EXPECT_TRUE(begins(error(with("abc origin ff pp ff", "4 0 0 -1\n0.5 2 0 0\n0 0 10 0\n"), first),
                       "layer:11: the box is triclinic (tilted)"));
}

TEST_F(LammpsDump, PlacesOutsideAlongAPeriodAreOtherImages) {
    const Source source =
        read(replaced(two_snapshots, "xs yu zs diameter\n3 1 0.25 -1.5", "x y z diameter\n3 1 1 5.7"));
    EXPECT_NEAR(source.position[0].y, 5.7e-6, 1e-20);
    // A small one may lie where a large one may.
    ReadOptions first;
    first.step.which = StepChoice::Which::first;
    const std::string skin = replaced(two_snapshots, "3 1 2 1 1 0.25", "3 1 3.5 1 1 0.01");
    EXPECT_EQ(read(skin, first).position.size(), 2U);
    EXPECT_TRUE(
        begins(error(replaced(skin, "3.5 1 1", "4.5 1 1"), first), "layer:15: the particle lies at x = 4.5e-06 m"));
}

TEST_F(LammpsDump, UnitsInTheNamesOfColumns) {
    const std::string text =
        "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp ff\n0 4\n0 4\n0 4\n"
        "ITEM: ATOMS ID X[mm] Y[mm] Z[mm] R[mm] vx[mm/s] vy[mm/s] vz[mm/s]\n1 1 2 3 0.5 1 2 3\n";
    const Source source = read(text);
    EXPECT_NEAR(source.position[0].z, 3e-3, 1e-18);
    EXPECT_NEAR(source.radius[0], 5e-4, 1e-18);
    EXPECT_NEAR(source.box->upper.z, 4e-3, 1e-18);
    EXPECT_NEAR(source.velocity[0].y, 2e-3, 1e-18);
    ReadOptions options;
    options.columns.radius = "R[mm]";
    EXPECT_NEAR(read(text, options).radius[0], 5e-4, 1e-18);
    options.columns.radius = "c_radius";
    EXPECT_TRUE(
        begins(error(text, options), "layer:9: there is no column \"c_radius\" among those of the file (id, x[mm]"));
    EXPECT_TRUE(
        begins(error(replaced(text, "R[mm]", "R")), "layer:9: the column \"r\" names no unit, but \"x[mm]\" does"));
    EXPECT_TRUE(
        begins(error(replaced(text, "R[mm]", "R[um]")), "layer:9: the columns \"x[mm]\" and \"r[um]\" name diff"));
    EXPECT_TRUE(begins(error("ITEM: UNITS\nsi\n" + text), "layer:11: the columns name a unit of 0.001 m"));
}

TEST_F(LammpsDump, TheLineToBlame) {
    const auto with = [&](const std::string& from, const std::string& to) {
        return error(replaced(two_snapshots, from, to));
    };
    EXPECT_TRUE(begins(with("3 1 2 1 1 0.25", "##### by hand\n3 1 2 1 1 0.25"),
                       "layer:15: the line has 3 columns, but each of the 2 atoms of the time step 100 has 6"));
    EXPECT_TRUE(begins(with("3 1 2 1 1 0.25", "a b c d e f\n3 1 2 1 1 0.25"), "layer:15: the line has no numbers"));
    EXPECT_TRUE(begins(with("3 1 2 1 1 0.25", "\n3 1 2 1 1 0.25"), "layer:15: an empty line stands among the 2 atoms"));
    EXPECT_TRUE(begins(with("ATOMS\n2", "ATOMS\n1"), "layer:15: \"3 1 2 1 1 0.25\" stands where an item should begin"));
    EXPECT_TRUE(begins(with("ATOMS\n2", "ATOMS\n3"), "layer:16: after 2 rows another head begins"));
}

TEST_F(LammpsDump, FilesThatEndInsideALine) {
    const std::string whole = two_snapshots.substr(0, two_snapshots.size() - 1);
    for (const std::string& text : {whole, whole + " ", whole.substr(0, whole.size() - 1)}) {
        EXPECT_TRUE(begins(error(text), "layer:27: the file ends inside this line")) << text;
    }
    EXPECT_EQ(read(whole + "\r\n").position.size(), 1U);
}

TEST_F(LammpsDump, StepsOneByOne) {
    const testing::TemporaryFolder folder;
    std::ofstream(folder / "steps") << two_snapshots;
    const Recording recording(folder / "steps");
    ASSERT_EQ(std::vector(recording.steps().begin(), recording.steps().end()), (std::vector<std::int64_t>{100, 200}));
    EXPECT_EQ(recording.read(1).position.size(), 1U);
    EXPECT_EQ(recording.read(0).position.size(), 2U);
    EXPECT_EQ(recording.read(0).step, 100);
}

TEST_F(LammpsDump, SentencesStayShortAndPlain) {
    // Found by fuzzing: column names went into the sentence as they were.
    std::string names = "ITEM: ATOMS id";
    for (int i = 0; i < 500; ++i) names += " c\xff" + std::to_string(i);
    ReadOptions first;
    first.step.which = StepChoice::Which::first;
    const std::string sentence = error(replaced(two_snapshots, "ITEM: ATOMS id type x y z radius", names), first);
    EXPECT_TRUE(
        begins(sentence, "layer:13: there is no column x, xs, xu or xsu among those of the dump (id, c??0, c??1"));
    EXPECT_LT(sentence.size(), 400U);
}

TEST_F(LammpsDump, DamagedFiles) {
    const auto broken = [&](const std::string& from, const std::string& to) {
        ReadOptions first;
        first.step.which = StepChoice::Which::first;
        return error(replaced(two_snapshots, from, to), first);
    };
    EXPECT_TRUE(begins(broken("7 1 1 1 1 0.5", "7 1 1 1 1"), "layer:14: the line has 5 columns, but \"ITEM: ATOMS\""));
    EXPECT_TRUE(begins(broken("7 1 1 1 1 0.5", "7 1 nan 1 1 0.5"),
                       "layer:14: column 3 (x): \"nan\": the number is not finite"));
    EXPECT_TRUE(begins(broken("7 1 1 1 1 0.5", "7 1 1 1 1 -0.5"),
                       "layer:14: column 6 (radius): \"-0.5\": a particle must have a size above zero"));
    EXPECT_TRUE(begins(broken("7 1 1 1 1 0.5", "3 1 1 1 1 0.5"),
                       "layer:15: the id 3 has been given to another particle already (line 14)"));
    EXPECT_TRUE(
        begins(broken("7 1 1 1 1 0.5", "7 1 9 1 1 0.5"), "layer:14: the particle lies at x = 9e-06 m, outside"));
    EXPECT_TRUE(begins(broken("-1 3\n", "3 -1\n"), "layer: the box ends along x at -1e-06 m"));
    EXPECT_TRUE(begins(broken("ATOMS\n2", "ATOMS\ntwo"), "layer:8: \"two\" is no number of atoms"));
    EXPECT_TRUE(begins(broken("ATOMS\n2", "ATOMS\n99999999999"),
                       "layer:16: after 2 rows another head begins, but 99999999999"));
    for (const std::size_t size : {20U, 60U, 120U, 150U, 200U, 270U, 300U}) {
        EXPECT_TRUE(begins(error(two_snapshots.substr(0, size)), "layer:")) << size;
    }
}

}  // namespace
}  // namespace recoat
