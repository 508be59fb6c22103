#include <gtest/gtest.h>

#include "solver/scene/time_step_limits.hpp"
#include "tests/support/scene_text.hpp"
#include "tests/support/verification.hpp"

namespace recoat {
namespace {

using testing::scene_of;
using testing::spread_text;
using testing::verify;
using testing::verify_relative;

double limit_of(const Scene& scene, const std::string& name) {
    for (const StepLimit& limit : time_step_limits(scene)) {
        if (limit.name == name) return limit.limit;
    }
    ADD_FAILURE() << "no limit " << name;
    return 0;
}

struct Row {
    const char* ratio;
    double rayleigh, time_001, time_005, time_05, overlap, normal, tangential;
};

class TimeStepLimits : public ::testing::TestWithParam<Row> {};

// The table of docs/physics.md section 4.1, to half a unit of the last printed digit.
TEST_P(TimeStepLimits, AgreeWithTheTable) {
    const Row row = GetParam();
    const Scene scene = scene_of(spread_text, {std::string("stiffness_ratio=") + row.ratio});
    verify_relative("Rayleigh time", limit_of(scene, "Rayleigh time"), row.rayleigh, 2e-5);
    verify_relative("contact time at 0.01 m/s", contact_time(scene, 0.01), row.time_001, 2e-4);
    verify_relative("contact time at 0.05 m/s", limit_of(scene, "contact time at 0.05 m/s"), row.time_005, 2e-4);
    verify_relative("contact time at 0.5 m/s", limit_of(scene, "contact time at 0.5 m/s"), row.time_05, 4e-4);
    verify_relative("greatest overlap at 0.05 m/s", largest_impact_overlap(scene, 0.05), row.overlap, 4.2e-3);
    // printed as frequency times 2e-8 s, to three decimals
    verify("normal frequency times 2e-8 s", 4e-8 / limit_of(scene, "normal contact frequency") - row.normal, 6e-4);
    verify("tangential frequency times 2e-8 s", 4e-8 / limit_of(scene, "tangential contact frequency") - row.tangential,
           6e-4);
}

INSTANTIATE_TEST_SUITE_P(StiffnessRatios, TimeStepLimits,
                         ::testing::Values(Row{"1", 2.7459e-8, 3.892e-7, 2.821e-7, 1.780e-7, 4.79e-9, .286, .485},
                                           Row{"0.1", 8.6834e-8, 9.777e-7, 7.086e-7, 4.471e-7, 1.20e-8, .114, .193},
                                           Row{"0.01", 2.7459e-7, 2.456e-6, 1.780e-6, 1.123e-6, 3.02e-8, .045, .077},
                                           Row{"0.001", 8.6834e-7, 6.169e-6, 4.471e-6, 2.821e-6, 7.60e-8, .018, .031}));

TEST(TimeStepLimits, AttractionContractsByAboutOnePercentAtBondNumber400) {
    // docs/physics.md section 2.5: b F_o/s_min is about 1 % at 2e-8 s; it grows with the square of the step
    const Scene scene = scene_of(spread_text, {"cohesion.bond_number=400"});
    const double share = 2e-8 / limit_of(scene, "van der Waals solve");
    EXPECT_NEAR(share * share, 0.01, 0.001);
}

TEST(TimeStepLimits, WithoutCohesionThereIsNoLimitFromIt) {
    for (const StepLimit& limit : time_step_limits(scene_of(spread_text))) EXPECT_NE(limit.name, "van der Waals solve");
}

}  // namespace
}  // namespace recoat
