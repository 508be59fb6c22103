#include "analyzer/output/voxel_volume.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <openvdb/io/File.h>
#include <openvdb/tools/LevelSetUtil.h>
#include <openvdb/tools/ParticlesToLevelSet.h>

#include "analyzer/fields/voxel_mask.hpp"
#include "common/error.hpp"
#include "common/output_file.hpp"
#include "common/version.hpp"

namespace recoat {
namespace {

constexpr double micrometre = 1e6;  ///< world units in a metre
constexpr double half_width = 3;    ///< of the narrow band of the level set [voxels]

/// The spheres that reach into the region and the period, with their images, in world coordinates, as OpenVDB wants
/// them.
class SphereList {
public:
    using PosType = openvdb::Vec3R;

    SphereList(const Layer& layer, const AnalysisConfig& config) {
        const double d = micrometre * config.particle_diameter;
        for (std::size_t i = 0; i < layer.size(); ++i) {
            const double r = layer.radius[i];
            if (layer.x[i] + r <= 0 || layer.x[i] - r >= layer.length) continue;
            const int turns = static_cast<int>(std::ceil(r / layer.width));
            for (int turn = -turns; turn <= turns; ++turn) {
                const double y = layer.y[i] + turn * layer.width;
                if (y + r <= 0 || y - r >= layer.width) continue;
                centre_.emplace_back(micrometre * config.x_begin + d * layer.x[i], micrometre * config.y_min + d * y,
                                     micrometre * config.base + d * layer.z[i]);
                radius_.push_back(d * r);
            }
        }
    }
    [[nodiscard]] std::size_t size() const { return centre_.size(); }
    void getPos(std::size_t i, openvdb::Vec3R& centre) const { centre = centre_[i]; }
    void getPosRad(std::size_t i, openvdb::Vec3R& centre, openvdb::Real& radius) const {
        centre = centre_[i];
        radius = radius_[i];
    }

private:
    std::vector<openvdb::Vec3R> centre_;
    std::vector<double> radius_;
};

/// Index (i, j, k) is the centre of the voxel whose lower corner lies i, j, k sides from the start of the region, y_min
/// and the base.
openvdb::math::Transform::Ptr transform_of(const AnalysisConfig& config, const openvdb::Vec3d& side) {
    auto transform = openvdb::math::Transform::createLinearTransform();
    transform->postScale(side);
    transform->postTranslate(micrometre * openvdb::Vec3d(config.x_begin, config.y_min, config.base) +
                             openvdb::Vec3d(side / 2));
    return transform;
}

openvdb::FloatGrid::Ptr solid_grid(const Layer& layer, const AnalysisConfig& config, int n) {
    const VoxelLattice voxels = layer.voxels(n);
    const openvdb::MaskTree mask = voxel_mask(layer, voxels, 0, static_cast<int>(voxels.rows));
    auto grid =
        openvdb::FloatGrid::create(std::make_shared<openvdb::FloatTree>(mask, 0.0F, 1.0F, openvdb::TopologyCopy()));
    const double d = micrometre * config.particle_diameter;
    grid->setTransform(transform_of(config, {d / voxels.per_x, d / voxels.per_y, d / voxels.per_z}));
    grid->setName("solid");
    grid->setGridClass(openvdb::GRID_FOG_VOLUME);
    return grid;
}

/// A distance has cubes for voxels, whether or not they fit into the period.
openvdb::FloatGrid::Ptr distance_grid(const Layer& layer, const AnalysisConfig& config, int n) {
    const double side = micrometre * config.particle_diameter / n;
    auto grid = openvdb::FloatGrid::create(static_cast<float>(half_width * side));
    grid->setTransform(transform_of(config, openvdb::Vec3d(side)));
    grid->setGridClass(openvdb::GRID_LEVEL_SET);
    grid->setName("distance");
    const SphereList spheres(layer, config);
    if (spheres.size() == 0) return grid;  // The library reads the first of no spheres.
    openvdb::tools::ParticlesToLevelSet<openvdb::FloatGrid> raster(*grid);
    raster.setRmin(0);
    raster.setRmax(std::numeric_limits<double>::max());
    raster.rasterizeSpheres(spheres);
    raster.finalize(true);
    return grid;
}

}  // namespace

void write_voxel_volume(const std::filesystem::path& place, const Layer& layer, const AnalysisConfig& config,
                        int voxels_per_dp) {
    const int n = voxels_per_dp;
    openvdb::initialize();
    openvdb::GridPtrVec grids = {solid_grid(layer, config, n), distance_grid(layer, config, n)};
    for (const auto& grid : grids) {
        grid->setCreator("recoat-analyze " + program_version());
        grid->insertMeta("unit", openvdb::StringMetadata("um"));
        grid->insertMeta("d_p", openvdb::DoubleMetadata(micrometre * config.particle_diameter));
        grid->insertMeta("voxels_per_dp", openvdb::Int32Metadata(n));
        grid->addStatsMetadata();
    }
    OutputFile output(place);
    try {
        openvdb::io::File file(output.path().string());
        file.write(grids);
        file.close();
    } catch (const openvdb::IoError& error) {
        throw InputError(fmt::format("{}: cannot be written: {}", place.string(), error.what()));
    }
    output.commit();
}

}  // namespace recoat
