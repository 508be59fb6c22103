#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "tests/analytic/watched_impact.hpp"
#include "tests/support/reference.hpp"
#include "tests/support/small_scene.hpp"
#include "tests/support/verification.hpp"

namespace recoat {
namespace {

using testing::head_on_pair;
using testing::pair_separation;
using testing::reference;
using testing::verify_relative;
namespace powder = testing::powder;

const std::string tabulated[] = {"0.1", "0.2", "0.4", "0.6", "0.8", "0.9"};

testing::WatchedImpact impact(double restitution, int steps, bool clip = false) {
    ContactModel model = powder::model();
    model.restitution = restitution;
    model.clip_normal = clip;
    constexpr double speed = 0.1, elastic_duration = 3.892e-6;
    const double time_step = elastic_duration / steps;
    const auto engine = head_on_pair(model, time_step, 3.5 * speed * time_step, speed).engine();
    return testing::watch_impact(*engine, time_step, speed, pair_separation);
}

// docs/physics.md section 5.3: duration and greatest overlap of damped impacts over those without damping.
TEST(DampedImpact, lasts_and_dives_as_the_table_says) {
    const auto elastic = impact(1, 200);
    for (const std::string& e : tabulated) {
        const auto found = impact(std::stod(e), 200);
        verify_relative("duration over the elastic one", found.duration / elastic.duration,
                        reference("restitution." + e + ".duration"), 1e-3, e);
        verify_relative("greatest overlap over the elastic one", found.overlap / elastic.overlap,
                        reference("restitution." + e + ".overlap"), 1e-3, e);
    }
}

// Section 1.4: the restitution that has to be asked for where the force is clipped. The dashpot of the smallest
// tabulated one, 0.1, is beyond any coefficient of restitution.
TEST(DampedImpact, with_the_force_clipped_takes_the_dashpot_of_the_table) {
    for (const std::string& e : tabulated) {
        const double ratio = reference("restitution." + e + ".needed") / std::sqrt(5.0);
        if (ratio >= 1) continue;
        const double asked = std::exp(-std::numbers::pi * ratio / std::sqrt(1 - ratio * ratio));
        verify_relative("restitution", impact(asked, 400, true).rate / 0.1, std::stod(e), 1e-3, e);
    }
}

}  // namespace
}  // namespace recoat
