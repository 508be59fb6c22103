/// Extended XYZ of exaDEM, LAMMPS, OVITO, ASE.

#include "tests/analyzer/reader_fixture.hpp"

namespace recoat {
namespace {

using testing::begins;
using testing::replaced;

class ExtendedXyz : public testing::ReaderTest {};

const std::string two_frames =
    "2\nLattice=\"4 0 0 0 2 0 0 0 3\" Origin=\"-1 0 0\" pbc=\"F T F\" "
    "Properties=species:S:1:pos:R:3:velo:R:3:radius:R:1:id:I:1 Timestep=100 Time=0.5\n"
    "P 1 1 0.5 4 5 6 0.5 7\nQ 2 1 0.25 1 0 0 0.25 9007199254740993\n"
    "1\nProperties=id:I:1:diameter:R:1:pos:R:3 Timestep=200 Time=1e0\n7 1 1 1 0.5\n";

TEST_F(ExtendedXyz, WhatPropertiesSay) {
    const Source source = read(two_frames, {.step = {StepChoice::Which::first, 0}});
    EXPECT_EQ(source.format, "extended-xyz");
    EXPECT_EQ(source.position, (std::vector<Vec3>{{1, 1, 0.5}, {2, 1, 0.25}}));
    EXPECT_EQ(source.radius, (std::vector<double>{0.5, 0.25}));
    EXPECT_EQ(source.velocity, (std::vector<Vec3>{{4, 5, 6}, {1, 0, 0}}));
    EXPECT_EQ(source.id, (std::vector<std::int64_t>{7, 9007199254740993}));
    EXPECT_EQ(source.type.names, (std::vector<std::string>{"P", "Q"}));
    EXPECT_EQ(source.type.of, (std::vector<std::uint32_t>{0, 1}));
    EXPECT_EQ(source.step, 100);
    EXPECT_EQ(source.time, 0.5);
    ASSERT_TRUE(source.box);
    EXPECT_EQ(source.box->lower, (Vec3{-1, 0, 0}));
    EXPECT_EQ(source.box->upper, (Vec3{3, 2, 3}));
    EXPECT_EQ(source.box->periodic, (std::array{false, true, false}));
}

TEST_F(ExtendedXyz, FramesAreTimeSteps) {
    const Source last = read(two_frames);
    EXPECT_EQ(last.step, 200);
    EXPECT_EQ(last.radius, (std::vector<double>{0.5}));
    EXPECT_FALSE(last.box);
    EXPECT_TRUE(last.velocity.empty());
    EXPECT_EQ(error(two_frames, {.step = {StepChoice::Which::number, 3}}),
              "layer: there is no time step 3; the file has 2: 100, 200");
    // Without a number in every frame they are counted.
    EXPECT_EQ(read(replaced(two_frames, "Timestep=100", "")).step, 1);
}

TEST_F(ExtendedXyz, OtherSpellings) {
    const Source ase = read(
        "1\nLattice=\"4 0 0 0 2 0 0 0 3\" Properties=species:S:1:pos:R:3:radius:R:1:flag:L:1:tensor:R:9 pbc=\"1 0 1\" "
        "name='two words' empty= lonely\nSi 1 1 1 0.5 T 1 2 3 4 5 6 7 8 9\n");
    EXPECT_EQ(ase.box->periodic, (std::array{true, false, true}));
    EXPECT_EQ(ase.box->lower, (Vec3{0, 0, 0}));
    const Source braces = read("1\nproperties={pos:R:3:Radius:R:1} LATTICE={4 2 3}\n1 1 1 0.5\n");
    EXPECT_EQ(braces.box->upper, (Vec3{4, 2, 3}));
    const Source plain = read("1\na comment\nP 1 2 3\n", {.radius = 0.5});
    EXPECT_EQ(plain.format, "extended-xyz");
    EXPECT_EQ(plain.position, (std::vector<Vec3>{{1, 2, 3}}));
    EXPECT_TRUE(read("0\nProperties=pos:R:3:radius:R:1\n").position.empty());
}

// As the specification of extended XYZ has arrays, and as boxes come out of rotations.
TEST_F(ExtendedXyz, ArraysInBracketsAndRoundedBoxes) {
    const auto box_of = [&](const std::string& comment) {
        return read("1\nProperties=pos:R:3:radius:R:1 " + comment + "\n1 1 1 0.5\n").box.value();
    };
    const Box brackets = box_of("Lattice=[[4, 0, 0], [0, 2, 0], [0, 0, 3]] pbc=[F, T, F] Origin=[0, -1, 0] energy=1");
    EXPECT_EQ(brackets.lower, (Vec3{0, -1, 0}));
    EXPECT_EQ(brackets.upper, (Vec3{4, 1, 3}));
    EXPECT_EQ(brackets.periodic, (std::array{false, true, false}));
    EXPECT_EQ(box_of("Lattice=\"4 1e-15 0 0 2 0 -1e-16 0 3\" pbc=\"false True 0\"").periodic,
              (std::array{false, true, false}));
    for (const std::string pbc : {"T", "[F, maybe, F]", "\"T T\""}) {
        EXPECT_TRUE(begins(error("1\nProperties=pos:R:3:radius:R:1 Lattice=\"4 2 3\" pbc=" + pbc + "\n1 1 1 0.5\n"),
                           "layer:2: \""))
            << pbc;
    }
}

// Types may be numbers, and the comment that of `dump xyz` of LAMMPS.
TEST_F(ExtendedXyz, PlainFramesOfLammps) {
    const std::string frames = "1\nAtoms. Timestep: 1000\n1 1 2 3\n1\nAtoms. Timestep: 2000\n2 4 5 6\n";
    const Source source = read(frames, {.radius = 0.5, .step = {StepChoice::Which::number, 1000}});
    EXPECT_EQ(source.position, (std::vector<Vec3>{{1, 2, 3}}));
    EXPECT_EQ(source.type.names, (std::vector<std::string>{"1"}));
    EXPECT_EQ(read(frames, {.radius = 0.5}).step, 2000);
}

TEST_F(ExtendedXyz, TheLineThatIsToBlame) {
    const auto with = [&](const std::string& from, const std::string& to) {
        return error(replaced(two_frames, from, to), {.step = {StepChoice::Which::first, 0}});
    };
    EXPECT_TRUE(
        begins(with("Q 2 1", "# a note\nQ 2 1"), "layer:4: the line has 3 columns, but each of the 2 particles of"));
    EXPECT_TRUE(
        begins(error("1\nProperties=pos:R:3:radius:R:1\n1 1 1 2.5"), "layer:3: the file ends inside this line"));
    EXPECT_TRUE(begins(error("1\na comment\nP 1 2 3"), "layer:3: the file ends inside this line"));
    EXPECT_NE(error("1\nProperties=pos:R:3:grain:R:1\n1 2 3 1\n").find("(it has: pos:0, pos:1, pos:2, grain)"),
              std::string::npos);
}

TEST_F(ExtendedXyz, WhatIsRefused) {
    const auto last_of = [&](const std::string& from, const std::string& to) {
        return error(replaced(two_frames, from, to));
    };
    EXPECT_TRUE(begins(error("1\nProperties=pos:R:3\n1 2 3\n"), "layer: the file gives no size of its particles"));
    EXPECT_TRUE(begins(error("1\nProperties=pos:R:2:radius:R:1\n1 2 3\n"), "layer:2: there is no column of z among"));
    EXPECT_TRUE(begins(error("1\nProperties=pos:R:3:radius:R\n1 2 3 4\n"), "layer:2: \"radius\" in Properties is not"));
    EXPECT_TRUE(begins(error("1\nProperties=pos:R:3:radius:R:1 Lattice=\"1 0.5 0 0 1 0 0 0 1\"\n0 0 0 1\n"),
                       "layer:2: the box is triclinic"));
    EXPECT_TRUE(
        begins(error("1\nProperties=pos:R:3:radius:R:1 Lattice=\"1 0\"\n0 0 0 1\n"), "layer:2: Lattice has 2 numbers"));
    EXPECT_TRUE(begins(last_of("7 1 1 1 0.5", "7 1 1 1"), "layer:7: the line has 4 columns, but Properties names 5"));
    EXPECT_TRUE(begins(last_of("7 1 1 1 0.5", "7 0 1 1 1"), "layer:7: column 2 (diameter): \"0\": a particle must"));
    EXPECT_TRUE(
        begins(error("1\nhead\nP 1 2 3 4\n", {.radius = 0.5}), "layer:3: the line has 5 columns, but plain XYZ"));
}

TEST_F(ExtendedXyz, WholeFramesBeforeADamagedOne) {
    const std::string cut = two_frames.substr(0, two_frames.find("7 1 1"));
    EXPECT_EQ(read(cut, {.step = {StepChoice::Which::first, 0}}).position.size(), 2U);
    EXPECT_EQ(read(cut, {.step = {StepChoice::Which::number, 100}}).position.size(), 2U);
    const std::string sentence = error(cut);
    EXPECT_TRUE(begins(sentence, "layer:6: the file ends here, but 1 particles of the frame 1 should follow"))
        << sentence;
    EXPECT_TRUE(sentence.ends_with("1 time step (100), which --step 100 reads")) << sentence;
}

}  // namespace
}  // namespace recoat
