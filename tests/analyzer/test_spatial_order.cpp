#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "analyzer/fields/spatial_order.hpp"
#include "tests/analyzer/support.hpp"

namespace recoat {
namespace {

using testing::layer_of;
using testing::unit_config;

TEST(SpatialOrder, KeepsEveryParticleAndWhatBelongsToIt) {
    for (const std::size_t count : {0, 1, 2, 700}) {
        const Layer layer = layer_of(testing::random_balls(count, 20, 9, 5), unit_config(20, 9));
        const Layer sorted = SpatialOrder(layer).apply(layer);
        ASSERT_EQ(sorted.size(), count);
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t p = sorted.file_index[i];
            EXPECT_EQ(sorted.x[i], layer.x[p]);
            EXPECT_EQ(sorted.y[i], layer.y[p]);
            EXPECT_EQ(sorted.z[i], layer.z[p]);
            EXPECT_EQ(sorted.radius[i], layer.radius[p]);
            EXPECT_EQ(sorted.in_region[i], layer.in_region[p]);
        }
        EXPECT_EQ(std::set(sorted.file_index.begin(), sorted.file_index.end()).size(), count);
    }
}

TEST(SpatialOrder, NeighboursAreNearInMemory) {
    const Layer layer = layer_of(testing::random_balls(20'000, 400, 20, 7), unit_config(400, 20));
    const Layer sorted = SpatialOrder(layer).apply(layer);
    double way = 0;
    for (std::size_t i = 1; i < sorted.size(); ++i) way += std::abs(sorted.x[i] - sorted.x[i - 1]);
    EXPECT_LT(way / static_cast<double>(sorted.size()), 2);
}

TEST(SpatialOrder, ResultsComeBackWithTheNumbersOfTheFile) {
    AnalysisConfig config = unit_config(20, 9);
    config.contact_mode = ContactMode::radii;
    const Layer layer = layer_of(testing::random_balls(500, 20, 9, 3), config);
    const ContactGraph graph = find_contacts(layer, config);
    const Clusters clusters = find_clusters(layer, graph);
    const SpatialOrder order(layer);
    const ContactGraph sorted_graph = find_contacts(order.apply(layer), config);
    const std::vector<std::uint32_t> numbers = order.coordination_numbers(sorted_graph);
    ASSERT_GT(graph.contacts(), 100U);
    for (std::size_t i = 0; i < layer.size(); ++i) {
        EXPECT_EQ(numbers[i], graph.coordination_number(i)) << i;
    }
    const Clusters restored_clusters = order.restore(find_clusters(order.apply(layer), sorted_graph));
    EXPECT_EQ(restored_clusters.of_particle, clusters.of_particle);
    ASSERT_EQ(restored_clusters.cluster.size(), clusters.cluster.size());
    for (std::size_t k = 0; k < clusters.cluster.size(); ++k) {
        const Cluster &found = restored_clusters.cluster[k], &expected = clusters.cluster[k];
        EXPECT_EQ(found.size, expected.size);
        EXPECT_EQ(found.percolates, expected.percolates);
        ASSERT_EQ(found.angle.has_value(), expected.angle.has_value());
        EXPECT_NEAR(found.angle.value_or(-1), expected.angle.value_or(-1), 1e-9);
    }
}

}  // namespace
}  // namespace recoat
