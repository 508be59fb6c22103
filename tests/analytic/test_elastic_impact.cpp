#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/reference.hpp"
#include "tests/support/small_scene.hpp"

namespace recoat {
namespace {

using testing::head_on_pair;
using testing::over_plane;
using testing::pair_separation;
using testing::reference;
using testing::SmallScene;

struct Impact {
    double overlap = 0, force = 0, duration = 0;
};

/// Height of the top of the parabola through three equidistant samples.
double peak(double before, double top, double after) {
    const double slope = 0.5 * (after - before), bend = before - 2 * top + after;
    return top - 0.5 * slope * slope / bend;
}

/// Watches one impact step by step; the ends lie between samples, where the spheres fly freely.
template <class Separation>
Impact watch(Engine& engine, double time_step, double speed, const Separation& separation) {
    std::vector<double> overlaps, forces;
    for (int step = 0; step < 400; ++step) {
        engine.advance(1);
        overlaps.push_back(-separation(engine.particles()));
        const auto contacts = engine.contacts();
        forces.push_back(contacts.empty() ? 0 : contacts.front().normal_force);
    }
    const auto touching = [&](std::size_t k) { return overlaps[k] > 0; };
    std::size_t first = 0;
    while (!touching(first)) ++first;
    std::size_t past = first, top = first;
    for (; touching(past); ++past)
        if (overlaps[past] > overlaps[top]) top = past;
    const double before = -overlaps[first - 1] / speed, after = -overlaps[past] / speed;
    const double sampled = static_cast<double>(past - first + 1) * time_step;
    return {peak(overlaps[top - 1], overlaps[top], overlaps[top + 1]),
            peak(forces[top - 1], forces[top], forces[top + 1]), sampled - before - after};
}

void expect_impact(const Impact& found, const std::string& name) {
    const auto expected = [&](const char* what) { return reference("elastic." + name + "." + what); };
    EXPECT_NEAR(found.overlap / expected("overlap"), 1, 1e-4) << name;
    EXPECT_NEAR(found.force / expected("force"), 1, 1e-4) << name;
    EXPECT_NEAR(found.duration / expected("duration"), 1, 1e-4) << name;
}

ContactModel elastic(double youngs_modulus, double poisson_ratio, double density) {
    ContactModel model;
    model.youngs_modulus = youngs_modulus;
    model.poisson_ratio = poisson_ratio;
    model.density = density;
    model.sliding_friction = 0.35;
    return model;
}

// docs/physics.md section 5.1, Chung & Ooi test 1: two spheres of 10 mm radius at 10 m/s each.
TEST(ElasticImpact, of_two_spheres_is_that_of_hertz) {
    const std::pair<const char*, ContactModel> cases[] = {{"glass", elastic(4.8e10, 0.2, 2800)},
                                                          {"limestone", elastic(2e10, 0.25, 2500)}};
    for (const auto& [name, model] : cases) {
        const double time_step = reference(std::string("elastic.") + name + ".duration") / 100;
        const auto engine = head_on_pair(model, time_step, 8.3 * 20 * time_step, 20, 0.02).engine();
        expect_impact(watch(*engine, time_step, 20, pair_separation), name);
    }
}

// Section 5.1, Chung & Ooi test 2: a sphere of 0.1 m radius at 0.2 m/s on a rigid wall.
TEST(ElasticImpact, on_a_rigid_wall_is_that_of_hertz) {
    const std::pair<const char*, ContactModel> cases[] = {{"aluminium", elastic(7e10, 0.3, 2699)},
                                                          {"magnesium", elastic(4e10, 0.35, 1800)}};
    for (auto [name, model] : cases) {
        model.wall_modulus = WallModulus::rigid;
        const double time_step = reference(std::string("elastic.") + name + ".duration") / 100;
        const auto engine = over_plane(model, time_step, 8.3 * 0.2 * time_step, {0, 0, -0.2}, {}, 0.2).engine();
        expect_impact(watch(*engine, time_step, 0.2, [](const ParticleTable& p) { return p.position[0].z - 0.1; }),
                      name);
    }
}

}  // namespace
}  // namespace recoat
