#include "solver/engine/snapshot.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace recoat {

Snapshot::Snapshot(const ParticleTable& table, std::vector<Wall> given) : walls(std::move(given)) {
    const std::size_t n = table.size();
    particles.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 x = table.position[i];
        particles.position[i] = {x.x, x.y, x.z, table.radius[i]};
        particles.velocity[i].set(table.velocity[i]);
        particles.contact_velocity[i].set(table.velocity[i]);
        particles.spin[i].set(table.angular_velocity[i]);
        particles.contact_spin[i].set(table.angular_velocity[i]);
        particles.id[i] = static_cast<std::int64_t>(i);
    }
    lost_rolling.assign(n, 0.0);
    contacts.wall_begin.assign(walls.now().size() + 1, 0);
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

double largest_displacement(const std::vector<Row>& now, const std::vector<Row>& before) {
    double square = 0;
    for (std::size_t i = 0; i < now.size(); ++i)
        square = std::max(square, squared_norm(now[i].xyz() - before[i].xyz()));
    return std::sqrt(square);
}

double folded(double y, double y_min, double period) {
    if (period <= 0) return y;
    const double inside = y - period * std::floor((y - y_min) / period);
    return inside < y_min + period ? inside : y_min;
}

void fold(Particles& particles, double y_min, double period) {
    for (Row& row : particles.position) row.y = folded(row.y, y_min, period);
}

void permute(Particles& particles, const std::vector<std::int32_t>& order) {
    const auto reorder = [&](auto& array) {
        auto sorted = array;
        for (std::size_t k = 0; k < order.size(); ++k) sorted[k] = array[static_cast<std::size_t>(order[k])];
        array.swap(sorted);
    };
    for (auto* rows : particles.all()) reorder(*rows);
    reorder(particles.id);
}

std::vector<std::int32_t> inverse(const std::vector<std::int32_t>& order) {
    std::vector<std::int32_t> place(order.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        place[static_cast<std::size_t>(order[k])] = static_cast<std::int32_t>(k);
    return place;
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

std::vector<ContactState> ordered(std::vector<ContactState> contacts) {
    for (ContactState& c : contacts) {
        if (c.second < 0 || c.first < c.second) continue;
        std::swap(c.first, c.second);
        c.normal = -c.normal;
        c.tangential_force = -c.tangential_force;
    }
    std::sort(contacts.begin(), contacts.end(), [](const ContactState& a, const ContactState& b) {
        return a.first != b.first ? a.first < b.first : a.second < b.second;
    });
    return contacts;
}

}  // namespace recoat
