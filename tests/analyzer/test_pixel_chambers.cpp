#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "analyzer/fields/pixel_distance.hpp"
#include "analyzer/fields/pixel_maxima.hpp"
#include "tests/analyzer/support.hpp"

namespace recoat {
namespace {

using testing::layer_of;
using testing::unit_config;

TEST(PixelDistance, AgreesWithAllPairsOfPixels) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const Layer layer = layer_of(testing::random_balls(8, 4, 3, seed), unit_config(4, 3));
        const PixelDistance pixels = pixel_distance(layer, 10, 1);
        ASSERT_EQ(pixels.nx, 60);
        ASSERT_EQ(pixels.ny, 30);
        std::vector<std::pair<int, int>> solid;
        for (int i = 0; i < 60; ++i) {
            for (int j = 0; j < 30; ++j) {
                for (std::size_t p = 0; p < layer.size(); ++p) {
                    const double dx = (i - 9.5) / 10 - layer.x[p];
                    double dy = std::abs((j + 0.5) / 10 - layer.y[p]);
                    dy = std::min(dy, 3 - dy);
                    if (dx * dx + dy * dy <= layer.radius[p] * layer.radius[p]) solid.emplace_back(i, j);
                }
            }
        }
        for (int i = 0; i < 60; ++i) {
            for (int j = 0; j < 30; ++j) {
                std::int64_t nearest = PixelDistance::infinite;
                for (const auto& [a, b] : solid) {
                    const std::int64_t dy = std::min(std::abs(j - b), 30 - std::abs(j - b));
                    nearest = std::min(nearest, (i - a) * (i - a) + dy * dy);
                }
                EXPECT_EQ(pixels.squared[static_cast<std::size_t>(i) * 30 + j], nearest);
            }
        }
    }
}

/// h-maxima by reconstruction: raise d - h under d until nothing changes, keep the pixels that stay h below.
std::vector<char> peaks(const PixelDistance& pixels, double height) {
    const auto size = pixels.squared.size();
    std::vector<double> value(size), raised(size);
    for (std::size_t p = 0; p < size; ++p) {
        value[p] = std::sqrt(static_cast<double>(pixels.squared[p]));
        raised[p] = std::max(value[p] - height, 0.0);
    }
    for (bool changed = true; std::exchange(changed, false);) {
        for (int i = 0; i < pixels.nx; ++i) {
            for (int j = 0; j < pixels.ny; ++j) {
                for (int a = std::max(i - 1, 0); a <= std::min(i + 1, pixels.nx - 1); ++a) {
                    for (int b = j - 1; b <= j + 1; ++b) {
                        const double level = raised[a * pixels.ny + (b + pixels.ny) % pixels.ny];
                        double& here = raised[i * pixels.ny + j];
                        const double higher = std::min(level, value[i * pixels.ny + j]);
                        if (higher > here) {
                            here = higher;
                            changed = true;
                        }
                    }
                }
            }
        }
    }
    std::vector<char> result(size);
    for (std::size_t p = 0; p < size; ++p) result[p] = value[p] > 0 && value[p] - raised[p] >= height - 1e-7;
    return result;
}

TEST(PixelMaxima, AgreeWithReconstruction) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const Layer layer = layer_of(testing::random_balls(25, 6, 4, seed), unit_config(6, 4));
        const PixelDistance pixels = pixel_distance(layer, 8, 2);
        for (const double height : {0.4, 1.0, 3.0}) {
            const std::vector<char> expected = peaks(pixels, height);
            std::vector<double> distances;
            for (std::size_t p = 0; p < expected.size(); ++p) {
                if (expected[p]) distances.push_back(std::sqrt(static_cast<double>(pixels.squared[p])));
            }
            std::ranges::sort(distances);
            const std::vector<PixelMaximum> found = pixel_maxima(pixels, height);
            ASSERT_FALSE(found.empty());
            EXPECT_LE(found.size(), distances.size());
            for (const PixelMaximum& maximum : found) {
                EXPECT_TRUE(std::ranges::binary_search(distances, maximum.distance));
            }
            std::vector<double> kinds = distances, found_kinds;
            for (const PixelMaximum& maximum : found) found_kinds.push_back(maximum.distance);
            std::ranges::sort(found_kinds);
            for (auto* list : {&kinds, &found_kinds}) {
                const auto rest = std::ranges::unique(*list);
                list->erase(rest.begin(), rest.end());
            }
            EXPECT_EQ(found_kinds, kinds);
        }
    }
    EXPECT_TRUE(pixel_maxima(pixel_distance(layer_of({}, unit_config(3, 3)), 4, 1), 1).empty());
}

}  // namespace
}  // namespace recoat
