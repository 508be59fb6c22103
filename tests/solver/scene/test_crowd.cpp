#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "solver/scene/crowd.hpp"

namespace recoat {
namespace {

struct Sphere {
    Vec3 centre;
    double radius;
};

/// All pairs and all images.
bool has_room(const std::vector<Sphere>& spheres, const Sphere& one, double period, double gap) {
    for (const Sphere& other : spheres) {
        for (int image = -1; image <= 1; ++image) {
            Vec3 d = one.centre - other.centre;
            d.y += image * period;
            if (norm(d) < one.radius + other.radius + gap) return false;
        }
    }
    return true;
}

// With one, two, three and more rows of cells across the period.
TEST(Crowd, DecidesAsAllPairsDo) {
    for (const double period : {2.1, 3.0, 4.3, 6.5, 11.0}) {
        std::mt19937_64 random(5);
        std::uniform_real_distribution<double> unit(0, 1);
        Crowd crowd({3, 0, 0}, {6, period, 0}, 2.05, 0.05);
        std::vector<Sphere> spheres;
        for (int k = 0; k < 3000; ++k) {
            const Vec3 centre{3 + 6 * unit(random), period * unit(random), 12 * unit(random)};
            const Sphere one{centre, 0.1 + 0.9 * unit(random) * unit(random)};
            const bool expected = has_room(spheres, one, period, 0.05);
            ASSERT_EQ(crowd.add(one.centre, one.radius), expected) << period << " " << k;
            if (expected) spheres.push_back(one);
        }
        EXPECT_GT(spheres.size(), 50U);
    }
}

}  // namespace
}  // namespace recoat
