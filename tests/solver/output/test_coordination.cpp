#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solver/output/coordination.hpp"

namespace recoat {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;

ParticleTable spheres(const std::vector<Vec3>& positions, double radius = 0.5) {
    ParticleTable table;
    table.position = positions;
    table.velocity.resize(positions.size());
    table.angular_velocity.resize(positions.size());
    table.radius.assign(positions.size(), radius);
    return table;
}

TEST(Coordination, CountsNeighboursCloserThan1005Diameters) {
    EXPECT_THAT(coordination_numbers(spheres({{0, 0, 0}, {1.0049, 0, 0}, {2.0098, 0, 0}, {9, 9, 9}}), 0),
                ElementsAre(1, 2, 1, 0));
    EXPECT_THAT(coordination_numbers(spheres({{0, 0, 0}, {0, 0, 1.0051}}), 0), Each(0));
}

TEST(Coordination, SeesImagesAcrossThePeriod) {
    EXPECT_THAT(coordination_numbers(spheres({{0, 0.2, 0}, {0, 9.2, 0}}), 10), ElementsAre(1, 1));
    EXPECT_THAT(coordination_numbers(spheres({{0, 0.2, 0}, {0, 9.2, 0}}), 0), ElementsAre(0, 0));
}

TEST(Coordination, CubicBlockHasThreeToSix) {
    std::vector<Vec3> positions;
    for (int i = 0; i < 27; ++i) positions.push_back({i % 3 * 1.0, i / 3 % 3 * 1.0, i / 9 * 1.0});
    const std::vector<double> counts = coordination_numbers(spheres(positions), 0);
    EXPECT_EQ(counts[0], 3);
    EXPECT_EQ(counts[1], 4);
    EXPECT_EQ(counts[4], 5);
    EXPECT_EQ(counts[13], 6);
}

TEST(Coordination, AgreesWithAllPairsForMixedSizes) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> place(0, 8), size(0.2, 0.7);
    ParticleTable table = spheres(std::vector<Vec3>(300));
    for (std::size_t i = 0; i < 300; ++i) {
        table.position[i] = {place(random), place(random), place(random)};
        table.radius[i] = size(random);
    }
    std::vector<double> expected(300, 0.0);
    for (std::size_t i = 0; i < 300; ++i) {
        for (std::size_t j = 0; j < 300; ++j) {
            for (double image : {-8.0, 0.0, 8.0}) {
                const Vec3 r = table.position[i] - table.position[j] + Vec3{0, image, 0};
                if (i != j && norm(r) < 1.005 * (table.radius[i] + table.radius[j])) ++expected[i];
            }
        }
    }
    EXPECT_EQ(coordination_numbers(table, 8), expected);
}

TEST(Coordination, NoParticlesNoNumbers) { EXPECT_TRUE(coordination_numbers({}, 0).empty()); }

}  // namespace
}  // namespace recoat
