#include <algorithm>

#include <gtest/gtest.h>

#include "tests/solver/engine/engine_scenes.hpp"

namespace recoat {
namespace {

using namespace testing;

ParticleTable after(EngineScene scene, InstructionSet set, Precision precision, std::int64_t steps) {
    scene.setup.resources = {};
    scene.setup.resources.instructions = set;
    scene.setup.precision = precision;
    const auto engine = scene.engine();
    engine->advance(steps);
    return engine->particles();
}

/// Largest distance between the same particles of two tables, in d_p; y is periodic.
double largest_distance(const ParticleTable& a, const ParticleTable& b, double y_period) {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        Vec3 d = a.position[i] - b.position[i];
        if (y_period > 0) d.y -= y_period * std::round(d.y / y_period);
        largest = std::max(largest, norm(d) / dp);
    }
    return largest;
}

class InstructionSets : public ::testing::TestWithParam<Variety> {};

// Vectors of four, of eight and none at all: loads, ends of loops and sums are different code for each.
TEST_P(InstructionSets, GiveTheSamePath) {
    const EngineScene scene = busy_box(GetParam());
    const auto path = [&](InstructionSet set) { return after(scene, set, Precision::double_precision, 150); };
    const ParticleTable plain = path(InstructionSet::baseline);
    ASSERT_GT(largest_distance(plain, scene.particles, scene.setup.y_period), 1e-3);
    for (const InstructionSet set : usable_instruction_sets())
        EXPECT_LT(largest_distance(plain, path(set), scene.setup.y_period), 1e-9) << name_of(set);
}

// Contacts in single precision: a hundred times closer than the steps themselves are to the truth.
TEST_P(InstructionSets, MixedPrecisionFollowsDouble) {
    const EngineScene scene = busy_box(GetParam());
    // Relative rolling is shared among the contacts that are listed: paths part where one list is made a step later.
    const std::int64_t steps = GetParam().rolling == RollingForm::relative ? 30 : 150;
    for (const InstructionSet set : usable_instruction_sets()) {
        const ParticleTable exact = after(scene, set, Precision::double_precision, steps);
        const ParticleTable mixed = after(scene, set, Precision::mixed, steps);
        const double distance = largest_distance(exact, mixed, scene.setup.y_period);
        EXPECT_LT(distance, 1e-5) << name_of(set);
        EXPECT_GT(distance, 0) << name_of(set);
    }
}

TEST(InstructionSet, MixedPrecisionBooksItsEnergy) {
    for (const double bond : {0.0, 50.0}) {
        EngineScene scene = busy_box({bond, RollingForm::own, 1});
        scene.setup.resources = {};
        scene.setup.precision = Precision::mixed;
        const auto engine = scene.engine();
        const EnergyLedger start = engine->ledger();
        engine->advance(400);
        const EnergyLedger end = engine->ledger();
        const double exchanged = end.dissipated();
        ASSERT_GT(exchanged, 0);
        const double balance = end.stored() + end.dissipated() - start.stored() - (end.wall_work - start.wall_work);
        EXPECT_LT(std::fabs(balance), 0.01 * exchanged) << bond;
    }
}

TEST(InstructionSet, HasAName) {
    EXPECT_EQ(name_of(usable_instruction_sets().front()), "baseline");
    EXPECT_EQ(name_of(InstructionSet::avx512), "avx512");
}

INSTANTIATE_TEST_SUITE_P(Varieties, InstructionSets, ::testing::ValuesIn(varieties));

}  // namespace
}  // namespace recoat
