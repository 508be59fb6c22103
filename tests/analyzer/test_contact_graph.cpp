#include <cmath>

#include <gtest/gtest.h>

#include "analyzer/fields/contact_graph.hpp"
#include "analyzer/metrics/coordination.hpp"
#include "tests/analyzer/support.hpp"

namespace recoat {
namespace {

using testing::Ball;
using testing::layer_of;
using testing::random_balls;
using testing::unit_config;

/// Neighbours of a particle by trying all others and their nearest images.
std::vector<std::size_t> touching(const Layer& layer, const AnalysisConfig& config, std::size_t i) {
    std::vector<std::size_t> found;
    for (std::size_t j = 0; j < layer.size(); ++j) {
        const double dy = std::remainder(layer.y[i] - layer.y[j], layer.width);
        const double distance = std::hypot(layer.x[i] - layer.x[j], dy, layer.z[i] - layer.z[j]);
        const double sum = config.contact_mode == ContactMode::radii ? layer.radius[i] + layer.radius[j] : 1;
        if (i != j && distance < config.contact_factor * sum) found.push_back(j);
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
        EXPECT_EQ(std::vector<std::size_t>(found.begin(), found.end()), expected) << i;
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
