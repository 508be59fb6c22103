#include <gtest/gtest.h>

#include "common/error.hpp"
#include "tests/solver/engine/engine_scenes.hpp"
#include "tests/support/throws_message.hpp"

namespace recoat {
namespace {

using namespace testing;

void expect_words(const std::string& sentence, const std::vector<std::string>& words) {
    for (const std::string& word : words) EXPECT_NE(sentence.find(word), std::string::npos) << word << ": " << sentence;
}

/// The particles are those of the moment before.
void expect_same(const ParticleTable& now, const ParticleTable& before) {
    EXPECT_EQ(now.position, before.position);
    EXPECT_EQ(now.velocity, before.velocity);
    EXPECT_EQ(now.angular_velocity, before.angular_velocity);
}

TEST(Faults, OverlappingStartNamesBothParticles) {
    EngineScene scene{paper_setup(), {}, {}};
    for (int k = 0; k < 5; ++k) add_particle(scene.particles, {2 * k * dp, 0, 0});
    add_particle(scene.particles, {6.5 * dp, 0, 0});
    const auto engine = scene.engine();
    const std::string sentence = message_of<SimulationFault>([&] { engine->advance(10); });
    expect_words(sentence, {"step 0", "particle 3", "particle 5", "overlaps", "2.5e-05", "reduce time_step"});
    EXPECT_EQ(engine->step(), 0);
    expect_same(engine->particles(), scene.particles);
}

TEST(Faults, OverlapWithAWallNamesIt) {
    EngineScene scene{paper_setup(50), {}, {plane("base", {}, {0, 0, 1}), box("anvil", {-1, -1, -1}, {1, 1, -dp})}};
    scene.walls[0].active = false;
    add_particle(scene.particles, {0, 0, dp});
    add_particle(scene.particles, {2 * dp, 0, -0.9 * dp});
    const auto engine = scene.engine();
    expect_words(message_of<SimulationFault>([&] { engine->advance(1); }), {"particle 1", "wall 'anvil'", "step 0"});
}

// A wall that goes further in a step than the close list reaches: the sphere that it meets is not in the list of the
// step before.
TEST(Faults, OverlapWithAWallThatJumpsNamesBoth) {
    for (const double bond : {0.0, 50.0}) {
        EngineScene scene{paper_setup(bond), {}, {plane("base", {0, 0, -dp}, {0, 0, 1})}};
        add_particle(scene.particles, {4 * dp, 0, -0.4 * dp});
        add_particle(scene.particles, {});
        Wall lid = plane("lid", {0, 0, 6.2 * dp}, {0, 0, -1});
        lid.velocity = {0, 0, -3 * dp / scene.setup.time_step};
        scene.walls.push_back(lid);
        const auto engine = scene.engine();
        expect_words(message_of<SimulationFault>([&] { engine->advance(10); }),
                     {"step 2 ", "particle 1 overlaps wall 'lid' by 1.5e-05 m"});
        EXPECT_EQ(engine->step(), 2);
    }
}

// Two particles in one place have no line through their centres, but still a fault.
TEST(Faults, ParticlesInOnePlaceAreAFault) {
    EngineScene scene{paper_setup(), {}, {}};
    add_particle(scene.particles, {});
    add_particle(scene.particles, {});
    const auto engine = scene.engine();
    expect_words(message_of<SimulationFault>([&] { engine->advance(1); }), {"particle 0", "particle 1"});
}

class TooFast : public ::testing::TestWithParam<double> {};

// Nobody moves on when one particle cannot.
TEST_P(TooFast, AParticleIsNamedAndNothingMoves) {
    EngineScene scene{paper_setup(GetParam()), {}, {}};
    add_particle(scene.particles, {}, {0.1, 0, 0}, {100, 0, 0});
    add_particle(scene.particles, {5 * dp, 0, 0}, {0, 12.4999999, 0});
    scene.setup.gravity = {0, 100, 0};
    add_particle(scene.particles, {9 * dp, 0, 0}, {0, 0.2, 0});
    const auto engine = scene.engine();
    std::string sentence;
    ParticleTable before = engine->particles();
    for (int step = 0; step < 10 && sentence.empty(); ++step) {
        before = engine->particles();
        try {
            engine->advance(1);
        } catch (const SimulationFault& fault) {
            sentence = fault.what();
        }
    }
    expect_words(sentence, {"particle 1 ", "12.5 m/s", "step " + std::to_string(engine->step())});
    expect_same(engine->particles(), before);
}

// A fault long after the start leaves what an engine has that stopped one step earlier, moving walls included.
TEST_P(TooFast, TheStateOfALongRunIsThatOfTheMomentBefore) {
    EngineScene scene = busy_box({GetParam(), RollingForm::own, 1, 200});
    scene.walls.push_back(box("hammer", {-infinite, -infinite, 4 * dp}, {infinite, infinite, 5 * dp}));
    const auto failing = scene.engine(), stopped = scene.engine();
    failing->advance(500);
    failing->set_wall_velocity(4, {0, 0, -0.15});
    const std::string sentence = message_of<SimulationFault>([&] { failing->advance(100000); });
    expect_words(sentence, {"step " + std::to_string(failing->step())});
    EXPECT_GT(failing->step(), 3000);
    stopped->advance(500);
    stopped->set_wall_velocity(4, {0, 0, -0.15});
    stopped->advance(failing->step() - 500);
    EXPECT_EQ(bits_of(*failing), bits_of(*stopped));
    EXPECT_EQ(failing->walls(), stopped->walls());
}

INSTANTIATE_TEST_SUITE_P(BondNumbers, TooFast, ::testing::Values(0.0, 50.0));

TEST(Faults, LeavingTheDomainNamesTheParticle) {
    EngineScene scene{paper_setup(), {}, {}};
    scene.setup.domain_upper.x = 3 * dp;
    add_particle(scene.particles, {});
    add_particle(scene.particles, {2.9 * dp, 0, 0}, {1, 0, 0});
    const auto engine = scene.engine();
    const std::string sentence = message_of<SimulationFault>([&] { engine->advance(20000); });
    expect_words(sentence, {"particle 1", "left the domain", "step " + std::to_string(engine->step())});
    // It is noticed when the pair lists are made anew: within the skin's width.
    EXPECT_GT(engine->particles().position[1].x, 3 * dp);
    EXPECT_LT(engine->particles().position[1].x, 3.1 * dp);
}

TEST(Faults, ThePeriodHasNoEnd) {
    EngineScene scene{paper_setup(), {}, {}};
    scene.setup.y_min = 0;
    scene.setup.y_period = 4 * dp;
    scene.setup.gravity = {};
    add_particle(scene.particles, {0, 3.9 * dp, 0}, {0, 1, 0});
    const auto engine = scene.engine();
    engine->advance(20000);
    const double travelled = 20000 * 1e-7 * 1.0;
    EXPECT_NEAR(engine->particles().position[0].y, std::fmod(3.9 * dp + travelled, 4 * dp), 1e-12);
}

}  // namespace
}  // namespace recoat
