#include "solver/output/wall_series.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/output_file.hpp"
#include "common/polydata_file.hpp"

namespace recoat {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// One moment of the series.
struct Row {
    std::int64_t step = 0;
    double time = 0;
    DrawnSpace particles;  ///< what the spheres take up
    std::vector<Wall> walls;
};

void push(std::vector<double>& values, Vec3 v) { values.insert(values.end(), {v.x, v.y, v.z}); }

/// Reads the numbers of a series one after the other.
class Numbers {
public:
    explicit Numbers(const std::vector<double>& values) : values_(values) {}
    [[nodiscard]] bool more() const { return at_ < values_.size(); }
    double number() { return values_.at(at_++); }
    Vec3 vector() {
        const double x = number(), y = number();
        return {x, y, number()};
    }

private:
    const std::vector<double>& values_;
    std::size_t at_ = 0;
};

std::vector<Row> rows_of(const std::vector<double>& values) {
    std::vector<Row> rows;
    for (Numbers numbers(values); numbers.more();) {
        Row row;
        const auto walls = static_cast<std::size_t>(numbers.number());
        row.step = static_cast<std::int64_t>(numbers.number());
        row.time = numbers.number();
        row.particles.lower = numbers.vector();
        row.particles.upper = numbers.vector();
        row.walls.resize(walls);
        for (Wall& wall : row.walls) {
            wall.kind = static_cast<WallKind>(static_cast<std::int32_t>(numbers.number()));
            wall.active = numbers.number() != 0;
            wall.point = numbers.vector();
            wall.normal = numbers.vector();
            wall.lower = numbers.vector();
            wall.upper = numbers.vector();
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

Vec3 least(Vec3 a, Vec3 b) { return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}; }
Vec3 most(Vec3 a, Vec3 b) { return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}; }
double finite_or(double value, double other) { return std::isfinite(value) ? value : other; }
Vec3 finite_or(Vec3 a, Vec3 b) { return {finite_or(a.x, b.x), finite_or(a.y, b.y), finite_or(a.z, b.z)}; }

/// The row's particles and what is finite of its walls.
DrawnSpace taken_up(const Row& row) {
    DrawnSpace space = row.particles;
    for (const Wall& wall : row.walls) {
        const bool plane = wall.kind == WallKind::plane;
        for (const Vec3 p : {plane ? wall.point : wall.lower, plane ? wall.point : wall.upper}) {
            space.lower = least(space.lower, finite_or(p, space.lower));
            space.upper = most(space.upper, finite_or(p, space.upper));
        }
    }
    return space;
}

/// Walls keep their length and width over the whole series; their height is that of the particles of the moment.
DrawnSpace space_of(const Row& row, const DrawnSpace& all, const DrawnSpace& domain, double diameter) {
    const Vec3 margin = 0.5 * Vec3{diameter, diameter, diameter};
    DrawnSpace space{all.lower - margin, all.upper + margin};
    space.upper.z = taken_up(row).upper.z + 4 * diameter;
    return {finite_or(domain.lower, space.lower), finite_or(domain.upper, space.upper)};
}

void add_step(PolyDataFile& file, const Row& row, const DrawnSpace& space) {
    std::vector<Vec3> points;
    std::vector<std::int64_t> numbers;
    PolyCells cells;
    for (std::size_t w = 0; w < row.walls.size(); ++w) {
        if (!row.walls[w].active) continue;
        for (const Polygon& polygon : wall_polygons(row.walls[w], space)) {
            for (const Vec3 corner : polygon) {
                cells.connectivity.push_back(static_cast<std::int64_t>(points.size()));
                points.push_back(corner);
            }
            cells.offsets.push_back(static_cast<std::int64_t>(points.size()));
            numbers.push_back(static_cast<std::int64_t>(w));
        }
    }
    file.add("CellData/Wall", numbers);
    file.finish_step(row.time, row.step, points, {}, cells);
}

}  // namespace

void WallSeries::add(const Engine& engine) {
    if (last_ == engine.step() && !empty()) return;
    last_ = engine.step();
    const std::vector<Wall>& walls = engine.walls();
    const ParticleTable particles = engine.particles();
    Vec3 lower = {infinity, infinity, infinity}, upper = -lower;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const double r = particles.radius[i];
        lower = least(lower, particles.position[i] - Vec3{r, r, r});
        upper = most(upper, particles.position[i] + Vec3{r, r, r});
    }
    if (particles.size() == 0) lower = upper = {};
    values_.insert(values_.end(), {static_cast<double>(walls.size()), static_cast<double>(last_), engine.time()});
    push(values_, lower);
    push(values_, upper);
    for (const Wall& wall : walls) {
        values_.push_back(static_cast<double>(wall.kind));
        values_.push_back(wall.active ? 1 : 0);
        for (const Vec3 v : {wall.point, wall.normal, wall.lower, wall.upper}) push(values_, v);
    }
}

void WallSeries::set_values(std::vector<double> values) {
    values_ = std::move(values);
    const std::vector<Row> rows = rows_of(values_);
    if (!rows.empty()) last_ = rows.back().step;
}

void WallSeries::write(const std::filesystem::path& file, const DrawnSpace& scene_domain, double diameter) const {
    const std::vector<Row> rows = rows_of(values_);
    DrawnSpace all = taken_up(rows.at(0));
    for (const Row& row : rows) {
        all.lower = least(all.lower, taken_up(row).lower);
        all.upper = most(all.upper, taken_up(row).upper);
    }
    OutputFile output(file);
    {
        PolyDataFile data(output.path(), 64, 16);
        data.make_polygon_array<std::int64_t>("Wall", 1, "");
        for (const Row& row : rows) add_step(data, row, space_of(row, all, scene_domain, diameter));
    }
    output.commit();
}

}  // namespace recoat
