#include "solver/start_overlaps.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "common/readable.hpp"
#include "solver/contact/material.hpp"
#include "solver/engine/limits.hpp"
#include "solver/scene/scene_notes.hpp"

namespace recoat {
namespace {

struct Overlaps {
    std::int64_t count = 0;
    std::set<std::int64_t> particles;
    ContactState deepest;

    explicit Overlaps(const std::vector<ContactState>& contacts) {
        for (const ContactState& contact : contacts) {
            if (contact.separation >= 0) continue;
            ++count;
            particles.insert(contact.first);
            if (contact.second >= 0) particles.insert(contact.second);
            if (contact.separation < deepest.separation) deepest = contact;
        }
    }
};

std::string partner(const Engine& engine, std::int64_t index) {
    if (index >= 0) return fmt::format("particle {}", index);
    return fmt::format("the wall \"{}\"", engine.walls()[static_cast<std::size_t>(-1 - index)].name);
}

}  // namespace

std::string start_overlaps(const Scene& scene, const Engine& engine) {
    constexpr double least = 0.01, usual = 2;  // radii; multiples of what is to be expected
    const Overlaps overlaps(engine.contacts());
    if (overlaps.count == 0) return {};
    const double share = -overlaps.deepest.separation / (0.5 * scene.smallest_diameter);
    if (share <= std::max(least, usual * expected_overlap(scene))) return {};
    const ParticleTable particles = engine.particles();
    double mass = 0;
    for (const std::int64_t i : overlaps.particles)
        mass += sphere_mass(particles.radius[static_cast<std::size_t>(i)], scene.model.density);
    const double energy = engine.ledger().elastic_normal;
    const std::string depth =
        fmt::format("by {} ({:.2g} of the smallest radius{})", readable(-overlaps.deepest.separation, "m"), share,
                    share > limits::overlap ? fmt::format("; a run stops at {:g}", limits::overlap) : "");
    const std::string pair =
        fmt::format("particle {} and {}", overlaps.deepest.first, partner(engine, overlaps.deepest.second));
    return fmt::format(
        "{} {}; the energy in {}, {}, is set free and would move these particles at {}: move them apart, or let them "
        "settle first",
        overlaps.count == 1 ? pair + " overlap at the start"
                            : fmt::format("{} contacts overlap at the start, that of {} most,", overlaps.count, pair),
        depth, overlaps.count == 1 ? "it" : "them", readable(energy, "J"),
        readable_speed(std::sqrt(2 * energy / mass)));
}

}  // namespace recoat
