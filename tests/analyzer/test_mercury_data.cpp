#include "tests/analyzer/reader_fixture.hpp"

namespace recoat {
namespace {

using testing::begins;
using testing::replaced;

const std::string two_snapshots =
    "2 0 0 0 0 4 2 3\n"
    "1 1 1 0 0 0 0.5 0 0 0 0 0 0 0\n"
    "2 1 1 0 0 0 0.25 0 0 0 0 0 0 0\n"
    "1 0.125 0 0 0 4 2 3\n"
    "3 1.5 1 0 0 -0.1 0.5 0 0 0 0 0 0 1\n";

class MercuryData : public testing::ReaderTest {};

TEST_F(MercuryData, Snapshots) {
    const Source last = read(two_snapshots);
    EXPECT_EQ(last.format, "mercury-data");
    EXPECT_EQ(last.position, (std::vector<Vec3>{{3, 1.5, 1}}));
    ASSERT_TRUE(last.box);
    EXPECT_EQ(last.box->upper, (Vec3{4, 2, 3}));
    ReadOptions options;
    options.step = {StepChoice::Which::number, 0};
    EXPECT_EQ(read(two_snapshots, options).radius, (std::vector<double>{0.5, 0.25}));
    options.step.number = 2;
    EXPECT_TRUE(begins(error(two_snapshots, options), "layer: there is no time step 2; the file has 2: 0, 1"));
}

TEST_F(MercuryData, TheDomainIsNoWall) {
    const Source source = read(replaced(two_snapshots, "3 1.5", "9 1.5"));
    EXPECT_EQ(source.position, (std::vector<Vec3>{{9, 1.5, 1}}));
    EXPECT_FALSE(source.box->closed);
}

TEST_F(MercuryData, TheLineToBlame) {
    const std::string comment = replaced(two_snapshots, "2 1 1 0 0 0 0.25", "# by hand\n2 1 1 0 0 0 0.25");
    EXPECT_TRUE(
        begins(error(comment), "layer:3: the line has 3 columns, but each of the 2 particles of the snapshot 0"));
    EXPECT_TRUE(
        begins(error(replaced(two_snapshots, "2 0 0 0", "3 0 0 0")), "layer:4: after 2 rows another head begins"));
    EXPECT_TRUE(begins(error(two_snapshots.substr(0, two_snapshots.size() - 1)), "layer:5: the file ends inside this"));
}

TEST_F(MercuryData, DamagedFiles) {
    EXPECT_TRUE(begins(error(replaced(two_snapshots, "1 0.125", "3 0.125")), "layer:5: the file ends here, but 3 par"));
    EXPECT_TRUE(begins(error(replaced(two_snapshots, "1 0.125", "0.5 0.125")), "layer:4: the line has 8 columns, but"));
    EXPECT_TRUE(begins(error(replaced(two_snapshots, "-0.1 0.5 0", "-0.1 0.5")), "layer:5: the line has 13 columns"));
    EXPECT_TRUE(
        begins(error(replaced(two_snapshots, "-0.1 0.5", "-0.1 -0.5")), "layer:5: column 7 (radius): \"-0.5\""));
    EXPECT_TRUE(begins(error(replaced(two_snapshots, "3 1.5", "nan 1.5")), "layer:5: column 1 (x): \"nan\""));
    EXPECT_TRUE(begins(error("1 0 0 0 4 3\n1 1 0 0 0.5 0 0 0\n"), "layer:1: the file is of a simulation in two dim"));
}

}  // namespace
}  // namespace recoat
