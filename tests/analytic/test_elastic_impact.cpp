#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "tests/analytic/watched_impact.hpp"
#include "tests/support/reference.hpp"
#include "tests/support/small_scene.hpp"
#include "tests/support/verification.hpp"

namespace recoat {
namespace {

using testing::head_on_pair;
using testing::over_plane;
using testing::pair_separation;
using testing::reference;
using testing::verify_relative;
using testing::watch_impact;

void expect_impact(const testing::WatchedImpact& found, const std::string& name, double speed) {
    const auto expected = [&](const char* what) { return reference("elastic." + name + "." + what); };
    verify_relative("greatest overlap", found.overlap, expected("overlap"), 1e-4, name);
    verify_relative("greatest force", found.force, expected("force"), 1e-4, name);
    verify_relative("duration", found.duration, expected("duration"), 1e-4, name);
    verify_relative("rebound speed", found.rate, speed, 1e-4, name);
}

ContactModel elastic(double youngs_modulus, double poisson_ratio, double density) {
    ContactModel model;
    model.youngs_modulus = youngs_modulus;
    model.poisson_ratio = poisson_ratio;
    model.density = density;
    model.sliding_friction = 0.35;
    return model;
}

// docs/physics.md section 5.1, Chung & Ooi test 1: two spheres of 10 mm radius at 10 m/s each, 100 steps per contact.
TEST(ElasticImpact, of_two_spheres_is_that_of_hertz) {
    const std::pair<const char*, ContactModel> cases[] = {{"glass", elastic(4.8e10, 0.2, 2800)},
                                                          {"limestone", elastic(2e10, 0.25, 2500)}};
    for (const auto& [name, model] : cases) {
        const double time_step = reference(std::string("elastic.") + name + ".duration") / 100;
        const auto engine = head_on_pair(model, time_step, 8.3 * 20 * time_step, 20, 0.02).engine();
        expect_impact(watch_impact(*engine, time_step, 20, pair_separation), name, 20);
    }
}

// Section 5.1, Chung & Ooi test 2: a sphere of 0.1 m radius at 0.2 m/s on a rigid wall.
TEST(ElasticImpact, on_a_rigid_wall_is_that_of_hertz) {
    std::pair<const char*, ContactModel> cases[] = {{"aluminium", elastic(7e10, 0.3, 2699)},
                                                    {"magnesium", elastic(4e10, 0.35, 1800)}};
    for (auto& [name, model] : cases) {
        model.wall_modulus = WallModulus::rigid;
        model.sliding_friction = 0;
        const double time_step = reference(std::string("elastic.") + name + ".duration") / 100;
        const auto engine = over_plane(model, time_step, 8.3 * 0.2 * time_step, {0, 0, -0.2}, {}, 0.2).engine();
        const auto height = [](const ParticleTable& p) { return p.position[0].z - 0.1; };
        expect_impact(watch_impact(*engine, time_step, 0.2, height), name, 0.2);
    }
}

}  // namespace
}  // namespace recoat
