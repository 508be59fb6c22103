#include <cmath>

#include <gtest/gtest.h>

#include "analyzer/readers/frame.hpp"

namespace recoat {
namespace {

/// Three particles of diameters 1, 2, 3 that stand on z = `base`.
Source standing_on(double base) {
    Source source;
    source.position = {{4, 1, base + 0.5}, {-2, 2, base + 1}, {7, 3, base + 1.5}};
    source.radius = {0.5, 1, 1.5};
    return source;
}

SourceInfo frame_of(Source source) {
    complete_frame(source);
    return source.info;
}

TEST(Frame, FromTheParticles) {
    const SourceInfo info = frame_of(standing_on(0));
    EXPECT_EQ(info.particle_diameter, 2);
    EXPECT_EQ(info.x_lower, -2);
    EXPECT_EQ(info.x_upper, 7);
    EXPECT_TRUE(std::isnan(info.y_period));
    EXPECT_EQ(info.y_lower, 1);
    EXPECT_EQ(info.y_upper, 3);
}

TEST(Frame, MedianOfAnEvenNumberInSixDigits) {
    Source source = standing_on(0);
    source.position.push_back({0, 0, 5});
    source.radius.push_back(2);
    EXPECT_EQ(frame_of(source).particle_diameter, 2.5);
    source.radius.assign(4, static_cast<double>(2.5e-5F));
    EXPECT_EQ(frame_of(source).particle_diameter, 5e-5);
}

TEST(Frame, PeriodOfTheBox) {
    Source source = standing_on(0);
    source.box = Box{.lower = {-9, -1, 0}, .upper = {9, 4, 9}};
    EXPECT_TRUE(std::isnan(frame_of(source).y_period));
    EXPECT_EQ(frame_of(source).y_lower, -1);
    source.box->periodic[1] = true;
    EXPECT_EQ(frame_of(source).y_min, -1);
    EXPECT_EQ(frame_of(source).y_period, 5);
}

TEST(Frame, Base) {
    EXPECT_EQ(frame_of(standing_on(0.75)).base, 0);
    EXPECT_EQ(frame_of(standing_on(-0.75)).base, 0);
    EXPECT_EQ(frame_of(standing_on(1.5)).base, 1.5);
    EXPECT_EQ(frame_of(standing_on(-3)).base, -3);
    Source source = standing_on(1.5);
    source.box = Box{.lower = {-9, -9, 1.25}, .upper = {9, 9, 9}};
    EXPECT_EQ(frame_of(source).base, 1.25);
    source.box->lower.z = -5;
    EXPECT_EQ(frame_of(source).base, 1.5);
    source.info.base = 0.25;
    EXPECT_EQ(frame_of(source).base, 0.25);
    lower_to_base(source, 1.5);
    EXPECT_EQ(source.position[1].z, 1);
    EXPECT_EQ(source.box->lower.z, -6.5);
}

TEST(Frame, NothingWithoutParticles) { EXPECT_TRUE(std::isnan(frame_of({}).x_lower)); }

}  // namespace
}  // namespace recoat
