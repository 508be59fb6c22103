/// VTKHDF files as other codes write them.

#include "common/hdf5.hpp"
#include "tests/analyzer/reader_fixture.hpp"

namespace recoat {
namespace {

using testing::begins;
using testing::message_of;
using Integers = std::vector<std::int64_t>;
using Reals = std::vector<double>;

class VtkHdf : public ::testing::Test {
protected:
    /// Points of two parts; radius, velocity and an array of no use.
    [[nodiscard]] hdf5::Group start(const std::string& type = "PolyData") const {
        auto root = hdf5::File::create(path_).create_group("VTKHDF");
        root.set_attribute("Version", Integers{2, 0});
        root.set_attribute("Type", type);
        root.write("NumberOfPoints", Integers{2, 1});
        root.write("Points", Reals{1, 2, 3, 4, 5, 6, 7, 8, 9}, {3, 3});
        const auto data = root.create_group("PointData");
        data.write("Radius", Reals{0.5, 0.25, 0.125});
        data.write("velocity", Reals{1, 0, 0, 0, 1, 0, 0, 0, 1}, {3, 3});
        data.write("stress", Reals(27), {3, 9});
        return root;
    }
    /// Two steps: part 0, part 1; the radius is there once.
    static void add_steps(const hdf5::Group& root) {
        const auto steps = root.create_group("Steps");
        steps.set_attribute("NSteps", std::int64_t{2});
        steps.write("Values", Reals{0.5, 1.5});
        steps.write("PointOffsets", Integers{0, 2});
        steps.write("PartOffsets", Integers{0, 1});
        steps.write("NumberOfParts", Integers{1, 1});
        steps.create_group("PointDataOffsets").write("Radius", Integers{0, 0});
    }
    [[nodiscard]] std::string error() const {
        const std::string message = message_of<InputError>([&] { (void)read_particles(path_); });
        const std::string place = folder_.path().string() + "/";
        return message.starts_with(place) ? message.substr(place.size()) : message;
    }

    testing::TemporaryFolder folder_;
    std::filesystem::path path_ = folder_ / "layer";
};

TEST_F(VtkHdf, AllPartsOfOneStep) {
    for (const auto* type : {"PolyData", "UnstructuredGrid"}) {
        (void)start(type);
        const Source source = read_particles(path_);
        EXPECT_EQ(source.format, "vtkhdf");
        EXPECT_EQ(source.position, (std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}));
        EXPECT_EQ(source.radius, (Reals{0.5, 0.25, 0.125}));
        EXPECT_EQ(source.velocity[1], (Vec3{0, 1, 0}));
    }
}

TEST_F(VtkHdf, AllPointsWhereNothingSaysHowMany) {
    auto root = hdf5::File::create(path_).create_group("VTKHDF");
    root.set_attribute("Type", std::string("PolyData"));
    root.write("Points", Reals{1, 2, 3, 4, 5, 6}, {2, 3});
    root.create_group("PointData").write("Radius", Reals{0.5, 0.25});
    EXPECT_EQ(read_particles(path_).position, (std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}}));
}

TEST_F(VtkHdf, Steps) {
    add_steps(start());
    const Recording recording(path_);
    ASSERT_EQ(recording.steps().size(), 2U);
    EXPECT_EQ(recording.read(0).position, (std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}}));
    const Source last = recording.read(1);
    EXPECT_EQ(last.position, (std::vector<Vec3>{{7, 8, 9}}));
    EXPECT_EQ(last.radius, (Reals{0.5}));
    EXPECT_EQ(last.velocity, (std::vector<Vec3>{{0, 0, 1}}));
}

TEST_F(VtkHdf, WhatIsRefused) {
    (void)start("ImageData");
    EXPECT_TRUE(begins(error(), "layer: the data set is of the kind \"ImageData\", which holds no particles"));
    (void)hdf5::File::create(path_).create_group("VTKHDF");
    EXPECT_TRUE(begins(error(), "layer: /VTKHDF: attribute Type: it is missing"));
    (void)hdf5::File::create(path_).create_group("somewhere");
    EXPECT_TRUE(begins(error(), "layer: this HDF5 file holds no particles that are known (no group VTKHDF)"));
    auto root = hdf5::File::create(path_).create_group("VTKHDF");
    root.set_attribute("Type", std::string("PolyData"));
    root.write("Points", Reals{1, 2, 3, 4}, {2, 2});
    EXPECT_TRUE(begins(error(), "layer: the array Points has not three columns"));
}

TEST_F(VtkHdf, NumbersThatDoNotFit) {
    const auto with = [&](const Integers& points, const Integers& offsets, std::int64_t steps) {
        {
            auto root = hdf5::File::create(path_).create_group("VTKHDF");
            root.set_attribute("Type", std::string("PolyData"));
            root.write("Points", Reals{1, 2, 3, 4, 5, 6}, {2, 3});
            root.write("NumberOfPoints", points);
            const auto group = root.create_group("Steps");
            group.set_attribute("NSteps", steps);
            group.write("Values", Reals{0, 1});
            group.write("PointOffsets", offsets);
        }
        return error();
    };
    constexpr std::int64_t huge = std::int64_t{1} << 60;
    EXPECT_TRUE(begins(with({1, huge}, {0, 1}, 2), "layer: NumberOfPoints holds 1152921504606846976, but there are 2"));
    EXPECT_TRUE(begins(with({1, -1}, {0, 1}, 2), "layer: NumberOfPoints holds -1"));
    EXPECT_TRUE(begins(with({1, 1}, {0, -1}, 2), "layer: the array PointOffsets holds no number of rows for step 1"));
    EXPECT_TRUE(begins(with({1, 1}, {0, huge}, 2), "layer: /VTKHDF: /Points: the array has too few rows"));
    EXPECT_TRUE(begins(with({1, 1}, {0, 2}, 2), "layer: /VTKHDF: /Points: the array has too few rows"));
    EXPECT_TRUE(begins(with({1, 1}, {0, 1}, 0), "layer: the file says that it has 0 time steps"));
    EXPECT_TRUE(begins(with({1, 1}, {0, 1}, huge), "layer: /VTKHDF: /Steps: /Values: the array has too few rows"));
}

}  // namespace
}  // namespace recoat
