#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "analyzer/analysis.hpp"
#include "analyzer/fields/contact_graph.hpp"
#include "analyzer/metrics/coordination.hpp"
#include "analyzer/uncertainty/uncertainty.hpp"
#include "tests/analyzer/support.hpp"

namespace recoat {
namespace {

using testing::Ball;
using testing::layer_of;
using testing::random_balls;
using testing::unit_config;

/// Neighbours of a particle by trying all others and itself at many images.
std::vector<Neighbour> touching(const Layer& layer, const AnalysisConfig& config, std::size_t i) {
    std::vector<Neighbour> found;
    for (std::uint32_t j = 0; j < layer.size(); ++j) {
        const double sum = config.contact_mode == ContactMode::radii ? layer.radius[i] + layer.radius[j] : 1;
        for (std::int32_t turn = -6; turn <= 6; ++turn) {
            const double distance = std::hypot(layer.x[i] - layer.x[j], layer.y[j] + turn * layer.width - layer.y[i],
                                               layer.z[i] - layer.z[j]);
            if ((i != j || turn != 0) && distance < config.contact_factor * sum) found.push_back({j, turn});
        }
    }
    return found;
}

struct Case {
    double length, width;
    std::size_t count;
    ContactMode mode;
};

class Contacts : public ::testing::TestWithParam<Case> {};

TEST_P(Contacts, AreThoseOfAllPairs) {
    const auto [length, width, count, mode] = GetParam();
    AnalysisConfig config = unit_config(length, width);
    config.contact_mode = mode;
    const Layer layer = layer_of(random_balls(count, length, width, 5), config);
    const ContactGraph graph = find_contacts(layer, config);
    std::size_t ends = 0;
    for (std::size_t i = 0; i < layer.size(); ++i) {
        const auto expected = touching(layer, config, i);
        const auto found = graph.neighbours(i);
        EXPECT_TRUE(std::ranges::equal(found, expected)) << i;
        ends += expected.size();
    }
    EXPECT_EQ(graph.contacts(), ends / 2);
    EXPECT_GT(ends, 0U);
}

// Periods of one, two and three boxes of the search, and many.
INSTANTIATE_TEST_SUITE_P(Sizes, Contacts,
                         ::testing::Values(Case{20, 10, 300, ContactMode::particle_diameter},
                                           Case{20, 10, 300, ContactMode::radii}, Case{6, 2, 40, ContactMode::radii},
                                           Case{6, 3, 60, ContactMode::particle_diameter},
                                           Case{6, 4, 60, ContactMode::radii},
                                           Case{900, 3, 900, ContactMode::particle_diameter}));

// A particle touches others, and itself, at several images.
INSTANTIATE_TEST_SUITE_P(ShortPeriods, Contacts,
                         ::testing::Values(Case{9, 1.9, 20, ContactMode::radii}, Case{9, 1, 12, ContactMode::radii},
                                           Case{9, 0.7, 12, ContactMode::particle_diameter},
                                           Case{9, 0.3, 9, ContactMode::radii}));

/// A sheet of touching particles along x and y, in a period of one, two or three of them.
class Sheet : public ::testing::TestWithParam<int> {};

TEST_P(Sheet, HasFourContactsPerParticle) {
    AnalysisConfig config = unit_config(8, GetParam());
    config.phi_window = 1;
    std::vector<Ball> balls;
    for (int i = -2; i < 10; ++i) {
        for (int j = 0; j < GetParam(); ++j) balls.push_back({i + 0.5, j + 0.25});
    }
    const Analysis analysis = analyse(layer_of(balls, config), config);
    EXPECT_EQ(analysis.coordination.cn_mean, 4);
    EXPECT_EQ(analysis.coordination.n_contacts, static_cast<std::size_t>(11 * GetParam() + 12 * GetParam()));
    EXPECT_EQ(analysis.cluster_sizes.max_cluster_size, balls.size());
    EXPECT_EQ(analysis.cluster_sizes.n_percolating, 1U);
    EXPECT_FALSE(analysis.clusters.cluster[0].angle);
    EXPECT_EQ(bootstrap(analysis, config).at("clusters", "cn_mean").interval[0].lower, 4);
    EXPECT_NEAR(analysis.phi_exact.median, std::numbers::pi / 6 / 1.5, 1e-12);
    EXPECT_NEAR(analysis.height.mean, 1, 1e-12);
    EXPECT_EQ(analysis.chamber_pores.separate.sizes.count, static_cast<std::size_t>(8 * GetParam()));
    EXPECT_NEAR(analysis.chamber_pores.separate.sizes.median, std::numbers::sqrt2 - 1, 1e-9);
    for (const VoxelMetrics& voxel : analysis.voxel) EXPECT_LT(voxel.phi_error.max, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Periods, Sheet, ::testing::Values(1, 2, 3));

TEST(ShortPeriod, AParticleThatTouchesItselfWindsRound) {
    const AnalysisConfig config = unit_config(6, 1);
    const Layer layer = layer_of({{1, 0.5}, {3, 0.5}}, config);
    const ContactGraph graph = find_contacts(layer, config);
    EXPECT_EQ(graph.contacts(), 2U);
    EXPECT_EQ(graph.coordination_number(0), 2U);
    const Clusters clusters = find_clusters(layer, graph);
    ASSERT_EQ(clusters.cluster.size(), 2U);
    EXPECT_EQ(clusters.cluster[0].size, 1U);
    EXPECT_TRUE(clusters.cluster[0].percolates);
}

TEST(ContactMode, GoesByTheRadiiUnlessToldOtherwise) {
    AnalysisConfig config = unit_config(10, 10);
    const std::vector<Ball> balls = {{1, 1, 0.8, 0.8}, {2.6, 1, 0.8, 0.8}, {5, 5, 0.2, 0.2}, {5.8, 5, 0.2, 0.2}};
    EXPECT_EQ(find_contacts(layer_of(balls, config), config).contacts(), 1U);
    config.contact_mode = ContactMode::particle_diameter;
    const ContactGraph graph = find_contacts(layer_of(balls, config), config);
    EXPECT_EQ(graph.contacts(), 1U);
    EXPECT_EQ(graph.coordination_number(2), 1U);
}

TEST(ContactRange, IsStrictlyBelowTheFactor) {
    const AnalysisConfig config = unit_config(10, 10);
    EXPECT_EQ(find_contacts(layer_of({{1, 1}, {2.00499, 1}}, config), config).contacts(), 1U);
    EXPECT_EQ(find_contacts(layer_of({{1, 1}, {2.00501, 1}}, config), config).contacts(), 0U);
}

TEST(Coordination, CountsTheRegionsParticlesAndTheirContactsOutside) {
    const AnalysisConfig config = unit_config(3, 10);
    // A chain of four along x: two in the region, one before it, one on its end, which is outside.
    const Layer layer = layer_of({{-0.2, 5}, {0.8, 5}, {1.8, 5}, {3, 8}, {2.8, 5}}, config);
    const CoordinationMetrics metrics = coordination_metrics(layer, find_contacts(layer, config));
    EXPECT_EQ(metrics.n_particles, 3U);
    EXPECT_EQ(metrics.n_contacts, 3U);
    EXPECT_EQ(metrics.cn_counts, (std::vector<std::size_t>{0, 1, 2}));
    EXPECT_DOUBLE_EQ(metrics.cn_mean, 5.0 / 3);
    EXPECT_DOUBLE_EQ(metrics.cn_fraction[2], 2.0 / 3);
}

TEST(Coordination, OfNothing) {
    const AnalysisConfig config = unit_config(3, 3);
    const Layer layer = layer_of({}, config);
    const CoordinationMetrics metrics = coordination_metrics(layer, find_contacts(layer, config));
    EXPECT_EQ(metrics.cn_counts, std::vector<std::size_t>{0});
    EXPECT_EQ(metrics.cn_mean, 0);
}

TEST(LayerFrame, WrapsAndCrops) {
    AnalysisConfig config = unit_config(3, 4);
    config.y_min = 1;
    const std::vector<Ball> balls = {{0, 0.5}, {-1e-9, 5}, {3 - 1e-9, 1 - 1e-18}, {-0.5, 4.9}};
    const Layer layer = layer_of(balls, config);
    EXPECT_EQ(layer.y, (std::vector<double>{3.5, 0, 0, 3.9000000000000004}));
    EXPECT_EQ(layer.in_region, (std::vector<char>{1, 1, 0, 0}));
    config.crop_first = true;
    EXPECT_EQ(layer_of(balls, config).file_index, (std::vector<std::size_t>{0, 1}));
}

}  // namespace
}  // namespace recoat
