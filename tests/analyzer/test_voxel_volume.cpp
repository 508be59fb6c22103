#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <openvdb/io/File.h>
#include <openvdb/tools/Interpolation.h>
#include <openvdb/tools/LevelSetMeasure.h>

#include "analyzer/output/voxel_volume.hpp"
#include "tests/analyzer/support.hpp"
#include "tests/support/temporary_folder.hpp"

namespace recoat {
namespace {

using testing::Ball;

/// d_p = 50 um, region from 1 mm, period from -0.1 mm, base at 0.2 mm.
AnalysisConfig config_of(double length, double width) {
    AnalysisConfig config;
    config.particle_diameter = 50e-6;
    config.density = 4430;
    config.clearance = 75e-6;
    config.x_begin = 1e-3;
    config.x_end = 1e-3 + length * 50e-6;
    config.y_min = -1e-4;
    config.y_period = width * 50e-6;
    config.base = 2e-4;
    return config;
}

/// A layer of balls given in d_p from the corner of the region.
Layer layer_at(const AnalysisConfig& config, const std::vector<Ball>& balls) {
    Source source;
    const double d = config.particle_diameter;
    for (const Ball& ball : balls) {
        source.position.push_back({config.x_begin + d * ball.x, config.y_min + d * ball.y, d * ball.z});
        source.radius.push_back(d * ball.radius);
    }
    return make_layer(source, config);
}

struct Volume {
    openvdb::FloatGrid::Ptr solid, distance;
};

Volume written_and_read(const Layer& layer, const AnalysisConfig& config, int n) {
    const testing::TemporaryFolder folder;
    write_voxel_volume(folder / "layer.vdb", layer, config, n);
    openvdb::io::File file((folder / "layer.vdb").string());
    file.open();
    return {openvdb::gridPtrCast<openvdb::FloatGrid>(file.readGrid("solid")),
            openvdb::gridPtrCast<openvdb::FloatGrid>(file.readGrid("distance"))};
}

TEST(VoxelVolume, SaysWhatItIs) {
    const AnalysisConfig config = config_of(6, 4);
    const Volume volume = written_and_read(layer_at(config, {{3, 2}}), config, 10);
    EXPECT_EQ(volume.solid->getGridClass(), openvdb::GRID_FOG_VOLUME);
    EXPECT_EQ(volume.distance->getGridClass(), openvdb::GRID_LEVEL_SET);
    for (const auto& grid : {volume.solid, volume.distance}) {
        EXPECT_NEAR(grid->voxelSize().x(), 5, 1e-12);
        EXPECT_EQ(grid->metaValue<std::string>("unit"), "um");
        EXPECT_DOUBLE_EQ(grid->metaValue<double>("d_p"), 50);
        EXPECT_EQ(grid->metaValue<std::int32_t>("voxels_per_dp"), 10);
        const openvdb::Vec3d corner = grid->indexToWorld(openvdb::Vec3d(-0.5));
        EXPECT_NEAR(corner.x(), 1000, 1e-9);
        EXPECT_NEAR(corner.y(), -100, 1e-9);
        EXPECT_NEAR(corner.z(), 200, 1e-9);
    }
}

TEST(VoxelVolume, SolidVoxelsAreThoseWhoseCentreIsInASphere) {
    const AnalysisConfig config = config_of(6, 4);
    // The second lies over the periodic boundary, the third reaches in from outside.
    const std::vector<Ball> balls = {{3, 2}, {1.3, 0.1, 0.6, 0.6}, {-0.2, 3}};
    const Volume volume = written_and_read(layer_at(config, balls), config, 10);
    const auto solid = volume.solid->getConstAccessor();
    std::size_t count = 0;
    for (int i = 0; i < 60; ++i) {
        for (int j = 0; j < 40; ++j) {
            for (int k = 0; k < 20; ++k) {
                bool inside = false;
                for (const Ball& ball : balls) {
                    for (const int turn : {-1, 0, 1}) {
                        const double x = (i + 0.5) / 10 - ball.x, y = (j + 0.5) / 10 - ball.y + 4 * turn,
                                     z = (k + 0.5) / 10 - ball.z;
                        inside |= x * x + y * y + z * z <= ball.radius * ball.radius;
                    }
                }
                ASSERT_EQ(solid.getValue({i, j, k}), inside ? 1.0F : 0.0F) << i << ' ' << j << ' ' << k;
                count += inside;
            }
        }
    }
    EXPECT_EQ(volume.solid->activeVoxelCount(), count);
}

TEST(VoxelVolume, DistanceIsThatToTheSurface) {
    const AnalysisConfig config = config_of(6, 4);
    const std::vector<Ball> balls = {{3, 2}, {1.3, 0.1, 0.6, 0.6}};
    const Volume volume = written_and_read(layer_at(config, balls), config, 20);
    std::size_t checked = 0;
    for (auto value = volume.distance->cbeginValueOn(); value; ++value) {
        const openvdb::Vec3d p =
            (volume.distance->indexToWorld(value.getCoord()) - openvdb::Vec3d(1000, -100, 200)) / 50;
        double nearest = 1e9;
        for (const Ball& ball : balls) {
            for (const int turn : {-1, 0, 1}) {
                nearest = std::min(nearest,
                                   std::hypot(p.x() - ball.x, p.y() - ball.y + 4 * turn, p.z() - ball.z) - ball.radius);
            }
        }
        ASSERT_NEAR(*value / 50, nearest, 1e-5);
        ++checked;
    }
    EXPECT_GT(checked, 10000U);
    const auto distance = volume.distance->getConstAccessor();
    EXPECT_LT(distance.getValue({60, 40, 10}), 0);  // the middle of the first, beyond the narrow band
    EXPECT_GT(distance.getValue({100, 40, 10}), 0);
}

TEST(VoxelVolume, LevelSetEnclosesTheVolumeOfTheSpheres) {
    const AnalysisConfig config = config_of(6, 4);
    const Volume volume = written_and_read(layer_at(config, {{3, 2}}), config, 20);
    const double sphere = std::numbers::pi / 6 * std::pow(50.0, 3);
    EXPECT_NEAR(openvdb::tools::levelSetVolume(*volume.distance) / sphere, 1, 0.01);
}

TEST(VoxelVolume, PolydisperseAndTinyParticlesAreNotLeftOut) {
    const AnalysisConfig config = config_of(6, 4);
    const Volume volume = written_and_read(layer_at(config, {{3, 2, 0.1, 0.1}, {3, 2, 20, 11}}), config, 10);
    EXPECT_LT(volume.distance->getConstAccessor().getValue({30, 20, 101}), 0);
    EXPECT_GT(volume.distance->activeVoxelCount(), 300000U);
    EXPECT_EQ(volume.solid->getConstAccessor().getValue({30, 20, 0}), 1.0F);
}

TEST(VoxelVolume, VoxelsAreStretchedToFitThePeriod) {
    // 31 and 22.5 voxels of a fifth of a diameter: 31 of 6.2/31 and 23 of 4.5/23; the distance keeps cubes.
    const AnalysisConfig config = config_of(6.21, 4.5);
    const std::vector<Ball> balls = {{3, 2}, {1.3, 0.1, 0.6, 0.6}};
    const Volume volume = written_and_read(layer_at(config, balls), config, 5);
    const openvdb::Vec3d side = volume.solid->voxelSize();
    EXPECT_NEAR(side.x(), 50 * 6.21 / 31, 1e-9);
    EXPECT_NEAR(side.y(), 50 * 4.5 / 23, 1e-9);
    EXPECT_NEAR(side.z(), 10, 1e-9);
    EXPECT_NEAR(volume.distance->voxelSize().y(), 10, 1e-9);
    EXPECT_TRUE(volume.distance->hasUniformVoxels());
    const auto solid = volume.solid->getConstAccessor();
    std::size_t count = 0;
    for (int i = 0; i < 31; ++i) {
        for (int j = 0; j < 23; ++j) {
            for (int k = 0; k < 10; ++k) {
                const openvdb::Vec3d p =
                    (volume.solid->indexToWorld(openvdb::Coord(i, j, k)) - openvdb::Vec3d(1000, -100, 200)) / 50;
                bool inside = false;
                for (const Ball& ball : balls) {
                    const double dy = std::remainder(p.y() - ball.y, 4.5);
                    inside |= std::hypot(p.x() - ball.x, dy, p.z() - ball.z) <= ball.radius;
                }
                ASSERT_EQ(solid.getValue({i, j, k}), inside ? 1.0F : 0.0F) << i << ' ' << j << ' ' << k;
                count += inside;
            }
        }
    }
    EXPECT_EQ(volume.solid->activeVoxelCount(), count);
    for (auto value = volume.distance->cbeginValueOn(); value; ++value) {
        const openvdb::Vec3d p =
            (volume.distance->indexToWorld(value.getCoord()) - openvdb::Vec3d(1000, -100, 200)) / 50;
        double nearest = 1e9;
        for (const Ball& ball : balls) {
            for (const int turn : {-1, 0, 1}) {
                nearest = std::min(
                    nearest, std::hypot(p.x() - ball.x, p.y() - ball.y + 4.5 * turn, p.z() - ball.z) - ball.radius);
            }
        }
        ASSERT_NEAR(*value / 50, nearest, 1e-5);
    }
}

TEST(VoxelVolume, OfAnEmptyLayerIsEmpty) {
    const AnalysisConfig config = config_of(6, 4);
    const Volume volume = written_and_read(layer_at(config, {}), config, 10);
    EXPECT_EQ(volume.solid->activeVoxelCount(), 0U);
    EXPECT_EQ(volume.distance->activeVoxelCount(), 0U);
}

}  // namespace
}  // namespace recoat
