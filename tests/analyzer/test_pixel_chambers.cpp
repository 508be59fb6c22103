#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "analyzer/fields/pixel_distance.hpp"
#include "analyzer/fields/pixel_maxima.hpp"
#include "tests/analyzer/support.hpp"

namespace recoat {
namespace {

using testing::layer_of;
using testing::unit_config;

/// The whole raster at once.
PixelDistance whole(const PixelRaster& raster) { return pixel_distance(raster, 0, raster.rows()); }

TEST(PixelDistance, AgreesWithAllPairsOfPixels) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const Layer layer = layer_of(testing::random_balls(8, 4, 3, seed), unit_config(4, 3));
        const PixelRaster raster(layer, 10, 1);
        ASSERT_EQ(raster.rows(), 60);
        ASSERT_EQ(raster.columns(), 30);
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
        const PixelDistance pixels = whole(raster), part = pixel_distance(raster, 17, 23);
        for (int i = 0; i < 60; ++i) {
            for (int j = 0; j < 30; ++j) {
                int nearest = std::numeric_limits<int>::max();
                for (const auto& [a, b] : solid) {
                    const int dy = std::min(std::abs(j - b), 30 - std::abs(j - b));
                    nearest = std::min(nearest, (i - a) * (i - a) + dy * dy);
                }
                EXPECT_EQ(pixels.at(i, j), static_cast<std::uint32_t>(nearest));
                if (i >= 17 && i < 23) {
                    EXPECT_EQ(part.at(i, j), static_cast<std::uint32_t>(nearest));
                }
            }
        }
    }
}

TEST(PixelDistance, ReachesAcrossWideGaps) {
    // One disk at each end of a long empty region. The centres of column 3 are in the disks from x = 299.016 on: row
    // 1196, 596 rows from row 600.
    const Layer layer = layer_of({{0.5, 1}, {299.5, 1}}, unit_config(300, 2));
    const PixelRaster raster(layer, 4, 0);
    const PixelDistance pixels = pixel_distance(raster, 600, 601);
    EXPECT_EQ(pixels.at(600, 3), 596U * 596U);
}

/// h-maxima by reconstruction: raise d - h under d until nothing changes, keep the pixels that stay h below.
std::vector<char> peaks(const PixelDistance& pixels, double height) {
    const auto size = pixels.squared.size();
    const int nx = static_cast<int>(pixels.rows), ny = static_cast<int>(pixels.columns);
    std::vector<double> value(size), raised(size);
    for (std::size_t p = 0; p < size; ++p) {
        value[p] = std::sqrt(static_cast<double>(pixels.squared[p]));
        raised[p] = std::max(value[p] - height, 0.0);
    }
    for (bool changed = true; std::exchange(changed, false);) {
        for (int i = 0; i < nx; ++i) {
            for (int j = 0; j < ny; ++j) {
                for (int a = std::max(i - 1, 0); a <= std::min(i + 1, nx - 1); ++a) {
                    for (int b = j - 1; b <= j + 1; ++b) {
                        const double level = raised[a * ny + (b + ny) % ny];
                        double& here = raised[i * ny + j];
                        const double higher = std::min(level, value[i * ny + j]);
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

/// Places and distances of the connected sets of peaks.
std::vector<PixelMaximum> connected(std::vector<char> peak, const PixelDistance& pixels) {
    const int nx = static_cast<int>(pixels.rows), ny = static_cast<int>(pixels.columns);
    std::vector<PixelMaximum> result;
    for (int seed = 0; seed < nx * ny; ++seed) {
        if (!peak[seed]) continue;
        peak[seed] = 0;
        std::vector<std::pair<int, int>> members = {{seed / ny, seed % ny}};
        double rows = 0, columns = 0;
        for (std::size_t k = 0; k < members.size(); ++k) {
            const auto [i, j] = members[k];
            rows += i;
            columns += j;
            for (int a = std::max(i - 1, 0); a <= std::min(i + 1, nx - 1); ++a) {
                for (int b = j - 1; b <= j + 1; ++b) {
                    char& there = peak[a * ny + ((b % ny) + ny) % ny];
                    if (std::exchange(there, 0)) members.emplace_back(a, b);
                }
            }
        }
        const auto count = static_cast<double>(members.size());
        result.push_back({rows / count, columns / count, std::sqrt(static_cast<double>(pixels.squared[seed]))});
    }
    return result;
}

void expect_same_maxima(std::vector<PixelMaximum> found, std::vector<PixelMaximum> expected, double columns) {
    ASSERT_EQ(found.size(), expected.size());
    for (const PixelMaximum& maximum : expected) {
        const auto partner = std::ranges::find_if(found, [&](const PixelMaximum& other) {
            const double gap = std::remainder(other.column - maximum.column, columns);
            return std::abs(other.row - maximum.row) < 1e-9 && std::abs(gap) < 1e-9 &&
                   other.distance == maximum.distance;
        });
        ASSERT_NE(partner, found.end()) << maximum.row << ' ' << maximum.column;
        found.erase(partner);
    }
}

TEST(PixelMaxima, AgreeWithReconstructionWhateverTheStrips) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const Layer layer = layer_of(testing::random_balls(25, 6, 4, seed), unit_config(6, 4));
        const PixelRaster raster(layer, 8, 2);
        const PixelDistance pixels = whole(raster);
        for (const double height : {0.4, 1.0, 3.0}) {
            const std::vector<PixelMaximum> expected = connected(peaks(pixels, height), pixels);
            ASSERT_FALSE(expected.empty());
            for (const std::int64_t rows : {0, 1, 2, 7, 40}) {
                expect_same_maxima(pixel_maxima(raster, height, rows), expected, 32);
            }
        }
    }
    EXPECT_TRUE(pixel_maxima(PixelRaster(layer_of({}, unit_config(3, 3)), 4, 1), 1).empty());
}

TEST(PixelMaxima, RidgesOfOneHeightAreOneMaximum) {
    // Two walls of touching disks: between them, ridges round the period; with strips of one row, of many parts.
    std::vector<testing::Ball> balls;
    for (int k = 0; k < 20; ++k) {
        for (const double x : {1.0, 4.0}) balls.push_back({x, 0.25 * k + 0.1});
    }
    const Layer layer = layer_of(balls, unit_config(5, 5));
    const PixelRaster raster(layer, 10, 0);
    const PixelDistance pixels = whole(raster);
    for (const double height : {0.4, 2.0}) {
        const std::vector<char> peak = peaks(pixels, height);
        const std::vector<PixelMaximum> once = pixel_maxima(raster, height), strips = pixel_maxima(raster, height, 1);
        ASSERT_FALSE(once.empty());
        ASSERT_EQ(strips.size(), once.size());
        for (std::size_t k = 0; k < once.size(); ++k) {
            EXPECT_EQ(strips[k].row, once[k].row);
            EXPECT_EQ(strips[k].distance, once[k].distance);
        }
        EXPECT_EQ(once.size(), connected(peak, pixels).size());
    }
}

}  // namespace
}  // namespace recoat
