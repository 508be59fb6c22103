#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "solver/engine/sleep_rule.hpp"
#include "tests/solver/engine/engine_scenes.hpp"

namespace recoat {
namespace {

using namespace testing;

constexpr std::size_t along = 8, across = 6, layers = 3;
/// So near that each touches its neighbours for sure.
constexpr double spacing = 0.99995 * dp;

/// Layers of touching spheres, each in the hollows of the one below it, between two planes and periodic in y: at rest
/// after some thousand steps, in which the overlaps that their weight makes die down. Above them a sphere that is
/// thrown at them and meets them after some 6700 steps.
EngineScene bed(const Variety& variety, bool with_sphere) {
    EngineScene scene;
    scene.setup = paper_setup(variety.bond);
    scene.setup.sleep = true;
    scene.setup.model.rolling_form = variety.rolling;
    scene.setup.y_period = static_cast<double>(across) * spacing;
    const double rise = spacing / std::sqrt(2.0);
    for (std::size_t z = 0; z < layers; ++z)
        for (std::size_t x = 0; x < along - z % 2; ++x)
            for (std::size_t y = 0; y < across; ++y)
                add_particle(scene.particles,
                             {(static_cast<double>(x) + 0.5 + 0.5 * static_cast<double>(z % 2)) * spacing,
                              (static_cast<double>(y) + 0.5 * static_cast<double>(z % 2)) * spacing,
                              0.5 * dp + static_cast<double>(z) * rise});
    if (with_sphere)
        add_particle(scene.particles, {2 * dp, 3.3 * dp, 0.5 * dp + static_cast<double>(layers - 1) * rise + 1.3 * dp},
                     {0.03, 0, -0.02});
    const double end = static_cast<double>(along) * spacing;
    scene.walls = {plane("base", {}, {0, 0, 1}), plane("left", {}, {1, 0, 0}), plane("right", {end, 0, 0}, {-1, 0, 0})};
    return scene;
}

/// Distance of the places of a particle [d_p].
double distance(const ParticleTable& p, const ParticleTable& q, std::size_t i) {
    Vec3 d = p.position[i] - q.position[i];
    d.y = std::remainder(d.y, static_cast<double>(across) * spacing);
    return norm(d) / dp;
}

/// The largest of them.
double largest_distance(const ParticleTable& p, const ParticleTable& q) {
    double largest = 0;
    for (std::size_t i = 0; i < p.size(); ++i) largest = std::max(largest, distance(p, q, i));
    return largest;
}

std::size_t awake(const Engine& engine) {
    return static_cast<std::size_t>(engine.save().integers.at("particles/awake").front());
}

std::unique_ptr<Engine> engine_of(EngineScene scene, bool sleep, int threads = 1) {
    scene.setup.sleep = sleep;
    scene.setup.resources.threads = threads;
    return scene.engine();
}

/// How far a bed that sleeps may be from one that does not after so many steps, by the rule: who falls asleep stands
/// within the reach of its place, twice that once it has been quiet, and would not have gone on faster than a reach in
/// the time after which it counts as quiet [d_p].
double creep(EngineScene scene, std::int64_t steps) {
    scene.setup.sleep = true;
    const SleepRule rule = sleep_rule(scene.setup, paper_radius);
    const double rests = static_cast<double>(steps) / static_cast<double>(rule.rest);
    return rule.reach * (SleepRule::patience + rests) / dp;
}

/// How far apart pushes that pass through the bed may bring the two in a time, by the rule: a guard that has not been
/// seen to move is within twice the reach of its place, and so presses on a sleeper, until the next look, by no more
/// than the stiffness under the weight times that [d_p].
double pushes(EngineScene scene, double time) {
    scene.setup.sleep = true;
    const SleepRule rule = sleep_rule(scene.setup, paper_radius);
    const double acceleration = 1.5 * SleepRule::patience * SleepRule::share_of_overlap * paper_gravity;
    return acceleration * static_cast<double>(rule.look) * scene.setup.time_step * time / dp;
}

/// Weight of one sphere times its diameter [J].
const double energy_unit = sphere_mass(paper_radius, 4430) * paper_gravity * dp;

TEST(SleepRule, ReachesATenthOfTheOverlapUnderTheWeight) {
    EngineSetup setup = paper_setup();
    setup.sleep = true;
    const SleepRule rule = sleep_rule(setup, paper_radius);
    // docs/physics.md section 5.8
    const double modulus = 0.5 * 0.001 * 110e9 / (1 - 0.3 * 0.3);
    const double weight = 4430 * 4.0 / 3 * 3.14159265358979 * std::pow(paper_radius, 3) * paper_gravity;
    EXPECT_NEAR(rule.reach / (0.1 * std::pow(0.75 * weight / (modulus * std::sqrt(paper_radius)), 2.0 / 3)), 1, 1e-6);
    EXPECT_EQ(rule.rest, std::llround(std::sqrt(2 * dp / paper_gravity) / 30 / 1e-7));
    EXPECT_EQ(rule.next(0, true), rule.look);
    EXPECT_EQ(rule.next(rule.look, true), 2 * rule.look);
    EXPECT_EQ(rule.next(rule.look, false), 4 * rule.look);
    EXPECT_TRUE(rule.due(3 * rule.look, true));
    EXPECT_FALSE(rule.due(3 * rule.look, false));
    EXPECT_FALSE(rule.due(3 * rule.look + 1, true));
}

TEST(SleepRule, NothingSleepsWithoutGravityOrWhereItIsOff) {
    EngineSetup setup = paper_setup();
    setup.sleep = false;
    EXPECT_FALSE(sleep_rule(setup, paper_radius).due(0, true));
    setup.sleep = true;
    setup.gravity = {};
    EXPECT_FALSE(sleep_rule(setup, paper_radius).due(0, true));
}

class Sleep : public ::testing::TestWithParam<Variety> {};

// The bed sleeps until the sphere comes, wakes where it strikes, and sleeps again: nobody can see the difference. Under
// its own weight a sphere has an overlap of 1e-5 d_p.
TEST_P(Sleep, ABedThatIsStruckMovesAsWithoutSleep) {
    const EngineScene scene = bed(GetParam(), true);
    const auto sleepy = engine_of(scene, true), sleepless = engine_of(scene, false);
    const double before = balance(sleepless->ledger()), strike = 6500 * scene.setup.time_step;
    std::size_t least = scene.particles.size(), most_after_sleep = 0;
    for (int portion = 0; portion < 20; ++portion) {
        sleepy->advance(500);
        sleepless->advance(500);
        if (least < 2) most_after_sleep = std::max(most_after_sleep, awake(*sleepy));
        least = std::min(least, awake(*sleepy));
        const double bound = creep(scene, sleepy->step()) + pushes(scene, std::max(0.0, sleepy->time() - strike));
        ASSERT_LT(largest_distance(sleepy->particles(), sleepless->particles()), bound) << sleepy->step();
        const EnergyLedger e = sleepy->ledger(), f = sleepless->ledger();
        EXPECT_NEAR(e.stored(), f.stored(), 1e-2 * energy_unit);
        EXPECT_NEAR(balance(e), before, 2 * std::abs(balance(f) - before) + 1e-3 * energy_unit);
    }
    EXPECT_LT(least, 2u) << "all but the sphere sleep";
    EXPECT_GT(most_after_sleep, 10u) << "the sphere has woken some";
    EXPECT_EQ(awake(*sleepless), scene.particles.size());
}

TEST_P(Sleep, TheSameBitsForAnyThreadsAndAfterARestart) {
    const EngineScene scene = bed(GetParam(), true);
    const auto whole = engine_of(scene, true), other = engine_of(scene, true, 3);
    std::size_t least = scene.particles.size();
    for (const std::int64_t steps : {4900, 1, 16, 17, 1833, 900}) {
        const auto restored = restore_engine(scene.setup, whole->save());
        whole->advance(steps);
        for (std::int64_t done = 0; done < steps; done += 150)
            other->advance(std::min<std::int64_t>(150, steps - done));
        restored->advance(steps);
        ASSERT_EQ(bits_of(*restored), bits_of(*whole)) << whole->step();
        ASSERT_EQ(bits_of(*other), bits_of(*whole)) << whole->step();
        ASSERT_EQ(restored->save().reals, whole->save().reals);
        ASSERT_EQ(restored->save().integers, whole->save().integers);
        least = std::min(least, awake(*whole));
    }
    EXPECT_LT(least, scene.particles.size() / 2);
}

// A bar that goes through the topmost layer: who is near is awake before it comes, and moves as without sleep.
TEST_P(Sleep, AMovingWallFindsTheBedAwake) {
    EngineScene scene = bed(GetParam(), false);
    const double top = 0.5 * dp + 2 * dp / std::sqrt(2.0);
    scene.walls.push_back(box("bar", {-dp, -infinite, top}, {-0.1 * dp, infinite, infinite}));
    const auto sleepy = engine_of(scene, true), sleepless = engine_of(scene, false);
    for (const auto& engine : {sleepy.get(), sleepless.get()}) engine->advance(6000);
    EXPECT_LT(awake(*sleepy), scene.particles.size() / 2);
    for (const auto& engine : {sleepy.get(), sleepless.get()}) {
        engine->set_wall_velocity(3, {0.05, 0, 0});
        if (engine == sleepy.get()) {
            EXPECT_GT(awake(*engine), 10u) << "those in its way";
            EXPECT_LT(awake(*engine), scene.particles.size());
        }
        engine->advance(3000);
    }
    // Relative rolling resistance is shared among the contacts that are listed: lists that last otherwise bring as
    // much.
    const double bound = GetParam().rolling == RollingForm::relative ? 5e-3 : 1e-3;
    EXPECT_LT(largest_distance(sleepy->particles(), sleepless->particles()), bound);
    EXPECT_GT(largest_distance(sleepy->particles(), scene.particles), 0.1) << "the bar has moved some";
    EXPECT_NEAR(sleepy->ledger().wall_work, sleepless->ledger().wall_work, 1e-3 * sleepless->ledger().wall_work);
}

TEST_P(Sleep, EverybodyWakesWhenAWallIsRemoved) {
    const EngineScene scene = bed(GetParam(), false);
    const auto sleepy = engine_of(scene, true), sleepless = engine_of(scene, false);
    for (const auto& engine : {sleepy.get(), sleepless.get()}) engine->advance(6000);
    EXPECT_LT(awake(*sleepy), scene.particles.size() / 2);
    const std::size_t contacts = sleepy->contacts().size();
    EXPECT_NEAR(static_cast<double>(contacts), static_cast<double>(sleepless->contacts().size()), 2);
    const double before = balance(sleepy->ledger()), sleepless_before = balance(sleepless->ledger());
    for (const auto& engine : {sleepy.get(), sleepless.get()}) {
        engine->remove_wall(2);
        EXPECT_EQ(awake(*engine), scene.particles.size());
        EXPECT_LT(engine->contacts().size(), contacts);
        engine->advance(3000);
    }
    EXPECT_NEAR(balance(sleepy->ledger()), before,
                1.5 * std::abs(balance(sleepless->ledger()) - sleepless_before) + 1e-3 * energy_unit);
    EXPECT_LT(largest_distance(sleepy->particles(), sleepless->particles()), 1e-5);
    EXPECT_GT(largest_distance(sleepy->particles(), scene.particles), 5e-5);
}

INSTANTIATE_TEST_SUITE_P(Varieties, Sleep,
                         ::testing::Values(Variety{0}, Variety{50}, Variety{0, RollingForm::relative}));

}  // namespace
}  // namespace recoat
