#include "solver/engine/snapshot.hpp"

#include <algorithm>
#include <limits>

#include "solver/engine/spatial_sort.hpp"

namespace recoat {

Snapshot initial_snapshot(const ParticleTable& table, std::vector<Wall> walls) {
    Snapshot snapshot;
    snapshot.walls = MovingWalls(std::move(walls));
    Particles& particles = snapshot.particles;
    const std::size_t n = table.size();
    particles.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        particles.position[i] = row(table.position[i], table.radius[i]);
        particles.velocity[i] = particles.contact_velocity[i] = row(table.velocity[i]);
        particles.spin[i] = particles.contact_spin[i] = row(table.angular_velocity[i]);
        particles.id[i] = static_cast<std::int64_t>(i);
    }
    snapshot.lost_rolling.assign(n, 0.0);
    snapshot.awake = n;
    for (const Vec3 x : table.position) snapshot.rest.push_back(row(x, 0));
    snapshot.contacts.wall_begin.assign(snapshot.walls.now().size() + 1, 0);
    snapshot.dormant.wall_begin = snapshot.contacts.wall_begin;
    return snapshot;
}

double smallest_radius(const Particles& p) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const Row& row : p.position) smallest = std::min(smallest, row.w);
    return smallest;
}

bool equal_radii(const Particles& p) {
    return std::all_of(p.position.begin(), p.position.end(),
                       [&](const Row& row) { return row.w == p.position.front().w; });
}

ParticleTable table_of(const Particles& particles, const EngineSetup& setup) {
    ParticleTable table;
    const std::size_t n = particles.size();
    table.position.resize(n);
    table.velocity.resize(n);
    table.angular_velocity.resize(n);
    table.radius.resize(n);
    for (std::size_t k = 0; k < n; ++k) {
        const auto i = static_cast<std::size_t>(particles.id[k]);
        const Row& x = particles.position[k];
        table.position[i] = {x.x, folded(x.y, setup.y_min, setup.y_period), x.z};
        table.velocity[i] = particles.contact_velocity[k].xyz();
        table.angular_velocity[i] = particles.contact_spin[k].xyz();
        table.radius[i] = x.w;
    }
    return table;
}

}  // namespace recoat
