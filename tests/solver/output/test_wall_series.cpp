#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/hdf5.hpp"
#include "solver/output/wall_series.hpp"
#include "tests/support/fake_engine.hpp"
#include "tests/support/temporary_folder.hpp"

namespace recoat {
namespace {

using ::testing::DoubleNear;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::Pair;
using Integers = std::vector<std::int64_t>;

constexpr double infinity = std::numeric_limits<double>::infinity();

class Walls : public ::testing::Test {
protected:
    Walls() {
        Wall base, gate, blade;
        base.name = "base";
        base.normal = {0, 0, 1};
        gate.name = "gate";
        gate.point = {3, 0, 0};
        gate.normal = {-1, 0, 0};
        blade.name = "blade";
        blade.kind = WallKind::box;
        blade.lower = {0, -infinity, 0.1};
        blade.upper = {1, infinity, infinity};
        blade.velocity = {2, 0, 0};
        particles_.position = {{2, 0.5, 0.5}};
        particles_.velocity = particles_.angular_velocity = {{}};
        particles_.radius = {0.5};
        walls_ = {base, gate, blade};
    }

    testing::FakeScript script_;
    ParticleTable particles_;
    std::vector<Wall> walls_;
    testing::TemporaryFolder folder_;
    const DrawnSpace domain_{{-1, 0, -0.5}, {9, 2, infinity}};
};

TEST_F(Walls, MoveAndDisappearAlongTheSteps) {
    testing::FakeEngine engine(script_, 0.5, particles_, walls_);
    WallSeries series;
    series.add(engine);
    engine.advance(2);
    engine.remove_wall(1);
    series.add(engine);
    series.add(engine);  // the same moment
    series.write(folder_ / "walls.vtkhdf", domain_, 1);

    const auto file = hdf5::File::open(folder_ / "walls.vtkhdf");
    const auto root = file.group("VTKHDF");
    EXPECT_EQ(root.group("Steps").integer_attribute("NSteps"), 2);
    EXPECT_THAT(root.read<double>("Steps/Values"), ElementsAre(0, 1));
    EXPECT_EQ(root.read<std::int64_t>("NumberOfPoints"), (Integers{4 + 4 + 24, 4 + 24}));
    EXPECT_EQ(root.read<std::int64_t>("CellData/Wall"), (Integers{0, 1, 2, 2, 2, 2, 2, 2, 0, 2, 2, 2, 2, 2, 2}));
    EXPECT_EQ(root.read<std::int64_t>("Steps/CellOffsets"), (Integers{0, 0, 0, 0, 0, 0, 8, 0}));
    EXPECT_EQ(root.read<std::int64_t>("Steps/CellDataOffsets/Wall"), (Integers{0, 8}));
    const std::vector<double> points = root.read<double>("Points");
    const auto x_of = [&](std::size_t first, std::size_t count) {
        std::pair<double, double> range{infinity, -infinity};
        for (std::size_t i = first; i < first + count; ++i) {
            range.first = std::min(range.first, points[3 * i]);
            range.second = std::max(range.second, points[3 * i]);
        }
        return range;
    };
    const auto near = [](double lower, double upper) {
        return Pair(DoubleNear(lower, 1e-12), DoubleNear(upper, 1e-12));
    };
    EXPECT_THAT(x_of(0, 4), near(-1, 9)) << "the base fills the domain";
    EXPECT_THAT(x_of(8, 24), near(0, 1));
    EXPECT_THAT(x_of(32 + 4, 24), near(2, 3)) << "the blade moved by 2 m/s in 1 s";
    EXPECT_THAT(points, Each(::testing::Truly([](double value) { return std::isfinite(value); })));
}

TEST_F(Walls, ReadBackTheSame) {
    testing::FakeEngine engine(script_, 0.5, particles_, walls_);
    WallSeries series, again;
    series.add(engine);
    again.set_values(series.values());
    again.add(engine);  // the moment it has already
    EXPECT_EQ(again.values(), series.values());
    series.write(folder_ / "a.vtkhdf", domain_, 1);
    again.write(folder_ / "b.vtkhdf", domain_, 1);
    EXPECT_EQ(hdf5::File::open(folder_ / "a.vtkhdf").group("VTKHDF").read<double>("Points"),
              hdf5::File::open(folder_ / "b.vtkhdf").group("VTKHDF").read<double>("Points"));
}

TEST_F(Walls, WithoutParticlesAndBoundsEndNearTheFiniteWalls) {
    testing::FakeEngine engine(script_, 0.5, ParticleTable{}, walls_);
    WallSeries series;
    series.add(engine);
    series.write(folder_ / "walls.vtkhdf", {{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}}, 1);
    const auto points = hdf5::File::open(folder_ / "walls.vtkhdf").group("VTKHDF").read<double>("Points");
    EXPECT_THAT(points, Each(::testing::Truly([](double value) { return std::abs(value) < 10; })));
}

}  // namespace
}  // namespace recoat
