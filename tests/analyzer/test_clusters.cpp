#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "analyzer/fields/clusters.hpp"
#include "analyzer/metrics/cluster_sizes.hpp"
#include "analyzer/metrics/orientation.hpp"
#include "tests/analyzer/support.hpp"

namespace recoat {
namespace {

using testing::Ball;
using testing::layer_of;
using testing::unit_config;

constexpr double degree = std::numbers::pi / 180;

/// A straight chain of touching particles from (x, y) at an angle to the spreading direction.
std::vector<Ball> chain(double x, double y, double angle, int count) {
    std::vector<Ball> balls;
    for (int k = 0; k < count; ++k) {
        balls.push_back({x + k * std::cos(angle * degree), y + k * std::sin(angle * degree)});
    }
    return balls;
}

Clusters clusters_of(const std::vector<Ball>& balls, const AnalysisConfig& config) {
    const Layer layer = layer_of(balls, config);
    return find_clusters(layer, find_contacts(layer, config));
}

class ChainAngle : public ::testing::TestWithParam<double> {};

TEST_P(ChainAngle, IsThatOfTheChainOverThePeriod) {
    const AnalysisConfig config = unit_config(30, 6);
    for (const int count : {2, 3, 5}) {
        for (const double y : {0.5, 5.7}) {
            const Clusters clusters = clusters_of(chain(15, y, GetParam(), count), config);
            ASSERT_EQ(clusters.cluster.size(), 1U);
            ASSERT_TRUE(clusters.cluster[0].angle);
            EXPECT_NEAR(*clusters.cluster[0].angle, std::abs(GetParam()), 1e-9);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Angles, ChainAngle, ::testing::Values(0.0, 10.0, 30.0, 45.0, 60.0, 89.0, 90.0, -30.0, -75.0));

TEST(Clusters, LongerThanHalfAPeriodAreUnwrappedAlongTheirContacts) {
    // Ten particles along y in a period of twelve: by the nearest image about one of them they would fold.
    const Clusters clusters = clusters_of(chain(10, 8, 80, 10), unit_config(20, 12));
    EXPECT_FALSE(clusters.cluster[0].percolates);
    EXPECT_NEAR(clusters.cluster[0].angle.value(), 80, 1e-9);
}

TEST(Clusters, RoundThePeriodHaveNoAngle) {
    const Clusters straight = clusters_of(chain(5, 0, 90, 6), unit_config(10, 6));
    EXPECT_TRUE(straight.cluster[0].percolates);
    EXPECT_FALSE(straight.cluster[0].angle);
    EXPECT_FALSE(straight.cluster[0].isotropic);

    // A gap in the ring: the same particles but one do not wind round.
    const Clusters open = clusters_of(chain(5, 0, 90, 5), unit_config(10, 6));
    EXPECT_FALSE(open.cluster[0].percolates);
    EXPECT_NEAR(open.cluster[0].angle.value(), 90, 1e-9);
}

TEST(Clusters, RingsThatDoNotWindRoundThePeriodDoNotPercolate) {
    std::vector<Ball> ring;
    const double radius = 0.5 / std::sin(std::numbers::pi / 12);
    for (int k = 0; k < 12; ++k)
        ring.push_back({8 + radius * std::cos(30 * k * degree), radius * std::sin(30 * k * degree)});
    const Clusters clusters = clusters_of(ring, unit_config(16, 5));
    ASSERT_EQ(clusters.cluster.size(), 1U);
    EXPECT_FALSE(clusters.cluster[0].percolates);
    EXPECT_TRUE(clusters.cluster[0].isotropic);
}

TEST(Clusters, WithoutADirectionInTheTopView) {
    const AnalysisConfig config = unit_config(10, 6);
    const double h = std::sqrt(3.0) / 2;
    const std::vector<std::vector<Ball>> shapes = {
        {{2, 5.5}, {3, 5.5}, {2, 0.5}, {3, 0.5}},  // square over the period
        {{2, 2}, {3, 2}, {2.5, 2 + h}},            // triangle
        {{2, 2}, {3, 2}, {2.5, 2 + h}, {1.5, 2 + h}, {1, 2}, {1.5, 2 - h}, {2.5, 2 - h}},
        {{2, 2, 0.5}, {2, 2, 1.5}},  // upright doublet
        {{2, 0, 0.5}, {2, 6, 1.5}},  // the same by its image
    };
    for (const auto& shape : shapes) {
        const Clusters clusters = clusters_of(shape, config);
        ASSERT_EQ(clusters.cluster.size(), 1U);
        EXPECT_TRUE(clusters.cluster[0].isotropic);
        EXPECT_FALSE(clusters.cluster[0].angle);
    }
}

TEST(ClusterSizes, CountMembersOutsideTheRegion) {
    const AnalysisConfig config = unit_config(4, 10);
    // A doublet with one member outside, a triplet outside, two single ones, one of them outside.
    const Layer layer = layer_of({{-0.5, 1}, {0.5, 1}, {6, 5}, {7, 5}, {8, 5}, {2, 5}, {9, 9}}, config);
    const Clusters clusters = find_clusters(layer, find_contacts(layer, config));
    const ClusterSizeMetrics metrics = cluster_size_metrics(layer, clusters);
    EXPECT_EQ(metrics.n_clusters, 2U);
    EXPECT_EQ(metrics.max_cluster_size, 3U);
    EXPECT_EQ(metrics.size_fraction, (std::map<std::size_t, double>{{1, 0.5}, {2, 0.5}}));
    EXPECT_EQ(clusters.of_particle, (std::vector<std::size_t>{0, 0, 1, 1, 1, 2, 3}));
}

TEST(Orientation, GroupsAndBins) {
    const AnalysisConfig config = unit_config(60, 12);
    std::vector<Ball> balls;
    const auto add = [&](const std::vector<Ball>& more) { balls.insert(balls.end(), more.begin(), more.end()); };
    add(chain(2, 2, 90, 2));    // the last bin holds 90
    add(chain(8, 2, 60, 2));    // on an edge: the bin above
    add(chain(14, 2, 0, 3));    // group 3-4
    add(chain(20, 2, 25, 4));   // group 3-4
    add(chain(30, 2, 25, 5));   // group >=5
    add(chain(40, 0, 90, 12));  // winds round the period
    add({{50, 5}});
    const Layer layer = layer_of(balls, config);
    const OrientationMetrics metrics =
        orientation_metrics(layer, find_clusters(layer, find_contacts(layer, config)), 10, 1e-6);
    EXPECT_EQ(metrics.bin_edges.front(), 0);
    EXPECT_EQ(metrics.bin_edges.back(), 90);
    const auto& [pairs, small, large] = metrics.groups;
    EXPECT_EQ(pairs.counts, (std::vector<std::size_t>{0, 0, 0, 0, 0, 0, 2, 0, 2}));
    EXPECT_EQ(small.counts, (std::vector<std::size_t>{3, 0, 4, 0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(large.counts, (std::vector<std::size_t>{0, 0, 5, 0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(large.particles, 17U);
    EXPECT_EQ(large.particles_without_angle, 12U);
    EXPECT_DOUBLE_EQ(small.fraction_of_all[2], 4.0 / 29);
}

}  // namespace
}  // namespace recoat
