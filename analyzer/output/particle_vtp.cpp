#include "analyzer/output/particle_vtp.hpp"

#include <limits>
#include <numeric>
#include <span>

#include "analyzer/output/type_numbers.hpp"
#include "analyzer/output/vtk_file.hpp"

namespace recoat {
namespace {

PolyCells vertices(std::vector<Vec3> points) {
    PolyCells cells{std::move(points), {}, {}};
    cells.corners.resize(cells.points.size());
    std::iota(cells.corners.begin(), cells.corners.end(), std::int64_t{0});
    cells.ends = cells.corners;
    for (std::int64_t& end : cells.ends) ++end;
    return cells;
}

/// Values of the particles at these places of the file.
template <class Value>
std::vector<Value> at(const std::vector<Value>& values, std::span<const std::size_t> places) {
    std::vector<Value> result;
    for (const std::size_t place : places) result.push_back(values[place]);
    return result;
}

void add_source(VtkFile& file, const Source& source, std::span<const std::size_t> places) {
    file.array("Radius", at(source.radius, places));
    if (!source.id.empty()) file.array("Id", at(source.id, places));
    const auto numbers = type_numbers(source);
    if (numbers && !source.type.of.empty()) {
        std::vector<std::int64_t> types;
        for (const std::size_t i : places) types.push_back((*numbers)[source.type.of[i]]);
        file.array("Type", types);
    }
    if (!source.velocity.empty()) file.array("Velocity", at(source.velocity, places));
    if (!source.angular_velocity.empty()) file.array("AngularVelocity", at(source.angular_velocity, places));
}

}  // namespace

void write_vtp(const std::filesystem::path& place, const Source& source) {
    std::vector<std::size_t> all(source.position.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    VtkFile file("PolyData");
    begin_piece(file, vertices(source.position), false);
    file.text("<PointData Scalars=\"Radius\">\n");
    add_source(file, source, all);
    file.text("</PointData>\n</Piece>\n");
    file.write(place);
}

void write_layer_vtp(const std::filesystem::path& place, const Analysis& analysis, const AnalysisConfig& config,
                     const Source& source) {
    const Layer& layer = analysis.layer;
    const double d = config.particle_diameter;
    std::vector<Vec3> points;
    std::vector<std::int64_t> number, cluster, size, inside;
    std::vector<double> angle;
    for (std::size_t i = 0; i < layer.size(); ++i) {
        points.push_back(
            {source.position[layer.file_index[i]].x, config.y_min + d * layer.y[i], config.base + d * layer.z[i]});
        number.push_back(static_cast<std::int64_t>(analysis.coordination_numbers[i]));
        const Cluster& mine = analysis.clusters.cluster[analysis.clusters.of_particle[i]];
        cluster.push_back(static_cast<std::int64_t>(analysis.clusters.of_particle[i]));
        size.push_back(static_cast<std::int64_t>(mine.size));
        angle.push_back(mine.angle.value_or(std::numeric_limits<double>::quiet_NaN()));
        inside.push_back(layer.in_region[i]);
    }
    VtkFile file("PolyData");
    begin_piece(file, vertices(std::move(points)), false);
    file.text("<PointData Scalars=\"CoordinationNumber\">\n");
    add_source(file, source, layer.file_index);
    file.array("CoordinationNumber", number);
    file.array("Cluster", cluster);
    file.array("ClusterSize", size);
    file.array("ClusterAngle", angle);
    file.array("InRegion", inside);
    file.text("</PointData>\n</Piece>\n");
    file.write(place);
}

}  // namespace recoat
