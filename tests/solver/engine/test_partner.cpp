#include <limits>

#include <gtest/gtest.h>

#include "solver/engine/partner.hpp"
#include "tests/support/paper_model.hpp"

namespace recoat {
namespace {

using testing::paper_model;
using testing::paper_radius;

constexpr double infinite = std::numeric_limits<double>::infinity();

void expect_near(Vec3 a, Vec3 b) { EXPECT_LT(norm(a - b), 1e-14); }

Wall unit_box(Vec3 lower = {0, 0, 0}, Vec3 upper = {1, 1, 1}) {
    return {"box", WallKind::box, {}, {}, lower, upper, {}, true};
}

TEST(Period, TakesTheNearestImage) {
    const Period period(10);
    expect_near(period.nearest({20, 6, 20}), {20, -4, 20});
    expect_near(period.nearest({1, -9, 2}), {1, 1, 2});
    expect_near(period.nearest({1, 4.9, 2}), {1, 4.9, 2});
    expect_near(Period(0).nearest({1, 400, 2}), {1, 400, 2});
}

TEST(PlaneShape, MeetsAlongItsNormal) {
    const PlaneShape plane({"ramp", WallKind::plane, {0, 0, 1}, {0.6, 0, 0.8}, {}, {}, {}, true});
    const Meeting meeting = plane.meet({0.6 * 3, 7, 1 + 0.8 * 3}, 2.5);
    EXPECT_NEAR(meeting.distance, 3, 1e-14);
    EXPECT_NEAR(meeting.separation, 0.5, 1e-14);
    expect_near(meeting.normal, {-0.6, 0, -0.8});
}

TEST(BoxShape, MeetsFacesEdgesAndCorners) {
    const BoxShape box(unit_box());
    const Meeting face = box.meet({0.5, 0.5, 3}, 1.0);
    EXPECT_NEAR(face.separation, 1, 1e-14);
    expect_near(face.normal, {0, 0, -1});
    const Meeting edge = box.meet({4, 0.5, 5}, 1.0);
    EXPECT_NEAR(edge.separation, 4, 1e-14);
    expect_near(edge.normal, {-0.6, 0, -0.8});
    const Meeting corner = box.meet({-1, -2, -2}, 1.0);
    EXPECT_NEAR(corner.separation, 2, 1e-14);
    expect_near(corner.normal, {1.0 / 3, 2.0 / 3, 2.0 / 3});
}

TEST(BoxShape, MayBeInfinite) {
    const BoxShape blade(unit_box({0, -infinite, 0.5}, {1, infinite, infinite}));
    const Meeting side = blade.meet({-2, 1e6, 40}, 1.0);
    EXPECT_NEAR(side.separation, 1, 1e-14);
    expect_near(side.normal, {1, 0, 0});
    const Meeting lower_edge = blade.meet({-3, -5, -3.5}, 1.0);
    EXPECT_NEAR(lower_edge.separation, 4, 1e-14);
    expect_near(lower_edge.normal, {0.6, 0, 0.8});
}

TEST(BoxShape, ACentreInsideIsTheDeepestOverlap) {
    const Meeting inside = BoxShape(unit_box()).meet({0.2, 0.3, 0.4}, 0.1);
    EXPECT_EQ(inside.separation, -0.1);
    EXPECT_EQ(norm(inside.normal), 0);
}

// The contact plane is that of the circle in which the spheres cut each other [docs/physics.md section 1.2].
TEST(ParticlePartner, ArmsEndInTheCommonPlane) {
    const ParticlePartner<AnySizes> partner{any_sizes(paper_model(1, 0)), Period(0), 0};
    Row position[2] = {{0, 0, 0, 3}, {4, 0, 0, 2}};
    ParticleView view{};
    view.position = position;
    const Meeting meeting = partner.meet(view, 0, 1);
    EXPECT_NEAR(meeting.separation, -1, 1e-14);
    const double first = partner.first_arm(view, 0, 1, meeting.distance);
    const double second = partner.second_arm(view, 1, meeting.distance, first);
    EXPECT_NEAR(first + second, 4, 1e-14);
    // Both right triangles to the circle have the same height.
    EXPECT_NEAR(9 - first * first, 4 - second * second, 1e-13);
    const ParticlePartner<AnySizes> radius_arms{partner.sizes, Period(0), 1};
    EXPECT_EQ(radius_arms.first_arm(view, 0, 1, 4), 3);
    EXPECT_EQ(radius_arms.second_arm(view, 1, 4, 3), 2);
}

TEST(ParticlePartner, MeetsThroughThePeriod) {
    const ParticlePartner<EqualSizes> partner{equal_sizes(paper_model(1, 0), paper_radius), Period(1e-3), 0};
    Row position[2] = {{0, 1e-5, 0, paper_radius}, {0, 0.97e-3, 0, paper_radius}};
    ParticleView view{};
    view.position = position;
    const Meeting meeting = partner.meet(view, 0, 1);
    EXPECT_NEAR(meeting.distance, 4e-5, 1e-18);
    expect_near(meeting.normal, {0, -1, 0});
}

}  // namespace
}  // namespace recoat
