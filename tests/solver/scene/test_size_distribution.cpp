#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "solver/scene/size_distribution.hpp"

namespace recoat {
namespace {

constexpr double um = 1e-6;

double phi(double x) { return 0.5 * (1 + std::erf(x / std::numbers::sqrt2)); }

/// Share finer than d of a distribution with the cumulative `f`, cut at a and b.
template <class F>
double cut(const F& f, double d, double a, double b) {
    return (f(d) - f(a)) / (f(b) - f(a));
}

std::vector<double> sample(const SizeDistribution& sizes, std::size_t count) {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<double> diameters(count);
    for (double& d : diameters) d = sizes.diameter(unit(random));
    std::ranges::sort(diameters);
    return diameters;
}

/// Largest distance between the steps of a sorted sample and a cumulative distribution (Kolmogorov-Smirnov).
template <class F>
double kolmogorov_distance(const std::vector<double>& sorted, const F& finer) {
    double distance = 0;
    const auto n = static_cast<double>(sorted.size());
    for (std::size_t k = 0; k < sorted.size(); ++k) {
        const double f = finer(sorted[k]), i = static_cast<double>(k);
        distance = std::max({distance, f - i / n, (i + 1) / n - f});
    }
    return distance;
}

constexpr std::size_t samples = 20000;
const double limit = 1.358 / std::sqrt(static_cast<double>(samples));  ///< passed by chance in 1 of 20

TEST(SizeDistribution, SampleOfACutNormalOneFollowsTheClosedForm) {
    const auto sizes = SizeDistribution::normal(50 * um, 10 * um, 30 * um, 65 * um, Weighting::number);
    const auto finer = [](double d) {
        return cut([](double x) { return phi((x - 50 * um) / (10 * um)); }, d, 30 * um, 65 * um);
    };
    const std::vector<double> diameters = sample(sizes, samples);
    EXPECT_GE(diameters.front(), 30 * um);
    EXPECT_LE(diameters.back(), 65 * um);
    EXPECT_LT(kolmogorov_distance(diameters, finer), limit);
    // the test can fail: a mean 1 um off does
    const auto other = SizeDistribution::normal(51 * um, 10 * um, 30 * um, 65 * um, Weighting::number);
    EXPECT_GT(kolmogorov_distance(sample(other, samples), finer), limit);
}

TEST(SizeDistribution, SampleOfACutLogNormalOneFollowsTheClosedForm) {
    const auto sizes = SizeDistribution::log_normal(40 * um, 1.5, 20 * um, 100 * um, Weighting::number);
    const auto finer = [](double d) {
        return cut([](double x) { return phi(std::log(x / (40 * um)) / std::log(1.5)); }, d, 20 * um, 100 * um);
    };
    EXPECT_LT(kolmogorov_distance(sample(sizes, samples), finer), limit);
}

TEST(SizeDistribution, ShareAndDiameterAreInverse) {
    const auto sizes = SizeDistribution::log_normal(40 * um, 1.5, 20 * um, 100 * um, Weighting::mass);
    for (double share = 0; share <= 1; share += 1.0 / 64) EXPECT_NEAR(sizes.finer(sizes.diameter(share)), share, 1e-12);
    EXPECT_EQ(sizes.diameter(0), 20 * um);
    EXPECT_EQ(sizes.diameter(1), 100 * um);
    EXPECT_EQ(sizes.finer(1 * um), 0);
    EXPECT_EQ(sizes.finer(1), 1);
}

// Hatch and Choate: a log-normal distribution by mass is one by number with the same geometric deviation and the median
// times exp(-3 ln^2 s).
TEST(SizeDistribution, MassBecomesNumberAsHatchAndChoateSay) {
    const double deviation = 1.4, width = std::log(deviation), median = 60 * um;
    const double by_number = median * std::exp(-3 * width * width);
    const auto sizes = SizeDistribution::log_normal(median, deviation, 8 * um, 400 * um, Weighting::mass);
    for (double x = -2.5; x <= 2.5; x += 0.25)
        EXPECT_NEAR(sizes.finer(by_number * std::exp(x * width)), phi(x), 2e-6) << x;
    EXPECT_NEAR(sizes.diameter_by_mass(0.5) / median, 1, 1e-6);
    EXPECT_NEAR(sizes.diameter(0.5) / by_number, 1, 1e-5);
}

TEST(SizeDistribution, MomentsOfALogNormalOneAreTheClosedOnes) {
    const double width = std::log(1.3), median = 50 * um;
    const auto sizes = SizeDistribution::log_normal(median, 1.3, 10 * um, 250 * um, Weighting::number);
    for (const int k : {-1, 1, 2, 3})
        EXPECT_NEAR(sizes.moment(k) / (std::pow(median, k) * std::exp(0.5 * k * k * width * width)), 1, 1e-5) << k;
    EXPECT_NEAR(sizes.moment(3) / sizes.moment(2) / (median * std::exp(2.5 * width * width)), 1, 1e-5);
    EXPECT_NEAR(sizes.moment(0), 1, 1e-12);
}

TEST(SizeDistribution, TableByNumberIsWhatItSays) {
    const auto sizes = SizeDistribution::table({20 * um, 30 * um, 60 * um}, {0, 0.25, 1}, Weighting::number);
    EXPECT_NEAR(sizes.diameter(0.125), 25 * um, 1e-12);
    EXPECT_NEAR(sizes.diameter(0.25), 30 * um, 1e-12);
    EXPECT_NEAR(sizes.diameter(0.5), 40 * um, 1e-12);
    EXPECT_NEAR(sizes.moment(1), 0.25 * 25 * um + 0.75 * 45 * um, 1e-12);
}

// In a class of equal mass per diameter from a to b there are (a^-2 - b^-2)/(2 (b - a)) spheres per mass.
TEST(SizeDistribution, TableByMassHasMoreSmallOnes) {
    const auto sizes = SizeDistribution::table({20 * um, 30 * um, 60 * um}, {0, 0.25, 1}, Weighting::mass);
    const auto per_mass = [](double a, double b) { return (1 / (a * a) - 1 / (b * b)) / (2 * (b - a)); };
    const double small = 0.25 * per_mass(20, 30), large = 0.75 * per_mass(30, 60);
    EXPECT_NEAR(sizes.finer(30 * um), small / (small + large), 1e-12);
    EXPECT_NEAR(sizes.diameter_by_mass(0.25), 30 * um, 1e-8 * um + 1e-9);
}

TEST(SizeDistribution, AnEmptyClassOfATableStaysEmpty) {
    const auto sizes =
        SizeDistribution::table({20 * um, 30 * um, 50 * um, 60 * um}, {0, 0.5, 0.5, 1}, Weighting::number);
    for (const double d : sample(sizes, 500)) EXPECT_TRUE(d <= 30.0001 * um || d >= 49.9999 * um) << d;
}

}  // namespace
}  // namespace recoat
