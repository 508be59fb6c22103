#include <limits>

#include <gtest/gtest.h>

#include "common/error.hpp"
#include "tests/solver/engine/engine_scenes.hpp"
#include "tests/support/throws_message.hpp"

namespace recoat {
namespace {

using namespace testing;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

EngineScene three_particles() {
    EngineScene scene{paper_setup(50), {}, {plane("base", {}, {0, 0, 1})}};
    for (int k = 0; k < 3; ++k) add_particle(scene.particles, {2 * k * dp, 0, dp});
    return scene;
}

template <class Spoil>
std::string refusal(const Spoil& spoil) {
    EngineScene scene = three_particles();
    spoil(scene);
    return message_of<InputError>([&] { static_cast<void>(scene.engine()); });
}

void expect_words(const std::string& sentence, const std::vector<std::string>& words) {
    for (const std::string& word : words) EXPECT_NE(sentence.find(word), std::string::npos) << word << ": " << sentence;
}

TEST(EngineInput, NumbersMustBeFinite) {
    expect_words(refusal([](EngineScene& s) { s.particles.position[1].y = nan; }), {"particle 1", "not a finite"});
    expect_words(refusal([](EngineScene& s) { s.particles.velocity[2].z = infinite; }), {"particle 2", "not a finite"});
    expect_words(refusal([](EngineScene& s) { s.particles.angular_velocity[0].x = nan; }), {"particle 0"});
}

TEST(EngineInput, RadiiMustBePositive) {
    for (const double radius : {0.0, -1e-6, nan, infinite})
        expect_words(refusal([&](EngineScene& s) { s.particles.radius[1] = radius; }), {"particle 1", "radius"});
}

TEST(EngineInput, CentresMustBeInTheDomain) {
    expect_words(refusal([](EngineScene& s) { s.particles.position[2].z = 2; }), {"particle 2", "domain"});
    expect_words(refusal([](EngineScene& s) { s.particles.position[0].y = -2; }), {"particle 0", "domain"});
}

TEST(EngineInput, ThePeriodMustHoldTwoParticles) {
    expect_words(refusal([](EngineScene& s) { s.setup.y_period = 2 * dp; }), {"period", "at least", "widen"});
    EngineScene wide = three_particles();
    wide.setup.y_period = 2.3 * dp;
    EXPECT_NO_THROW(static_cast<void>(wide.engine()));
}

TEST(EngineInput, WallsMustBeUsable) {
    expect_words(refusal([](EngineScene& s) { s.walls[0].normal = {0, 0, 2}; }), {"wall 'base'", "normal", "length 1"});
    expect_words(refusal([](EngineScene& s) { s.walls[0].normal = {}; }), {"wall 'base'", "normal"});
    expect_words(refusal([](EngineScene& s) { s.walls[0].point.x = nan; }), {"wall 'base'", "finite"});
    expect_words(refusal([](EngineScene& s) { s.walls[0].velocity.x = infinite; }), {"wall 'base'", "finite"});
    expect_words(refusal([](EngineScene& s) {
                     s.walls[0] = box("bar", {1, 0, 0}, {0, 1, 1});
                 }),
                 {"wall 'bar'", "lower"});
    expect_words(refusal([](EngineScene& s) { s.walls[0] = box("bar", {0, nan, 0}, {1, 1, 1}); }), {"wall 'bar'"});
}

TEST(EngineInput, NoParticlesAreFine) {
    for (const double bond : {0.0, 50.0}) {
        EngineScene scene{paper_setup(bond), {}, {plane("base", {}, {0, 0, 1})}};
        const auto engine = scene.engine();
        engine->advance(1000);
        EXPECT_EQ(engine->step(), 1000);
        EXPECT_EQ(engine->particles().size(), 0u);
        EXPECT_TRUE(engine->contacts().empty());
        EXPECT_EQ(engine->kinetic_energy(), 0);
        EXPECT_EQ(engine->ledger().stored(), 0);
        EXPECT_EQ(engine->largest_overlap(), 0);
    }
}

// A projectile: the leapfrog is exact for a constant force.
TEST(EngineInput, OneParticleFallsAsGalileoSaid) {
    for (const double bond : {0.0, 50.0}) {
        EngineScene scene{paper_setup(bond), {}, {}};
        add_particle(scene.particles, {0, 0, 0.5}, {0.3, -0.1, 0.2}, {10, 20, 30});
        const auto engine = scene.engine();
        engine->advance(20000);
        const double t = 20000 * 1e-7;
        const ParticleTable now = engine->particles();
        EXPECT_NEAR(now.position[0].x, 0.3 * t, 1e-14);
        EXPECT_NEAR(now.position[0].y, -0.1 * t, 1e-14);
        EXPECT_NEAR(now.position[0].z, 0.5 + 0.2 * t - 0.5 * 9.81 * t * t, 1e-13);
        EXPECT_NEAR(now.velocity[0].z, 0.2 - 9.81 * t, 1e-12);
        EXPECT_EQ(now.angular_velocity[0], (Vec3{10, 20, 30}));
        EXPECT_NEAR(engine->time(), t, 1e-15);
    }
}

TEST(EngineInput, PositionsInYAreFolded) {
    EngineScene scene = three_particles();
    scene.setup.y_min = -dp;
    scene.setup.y_period = 5 * dp;
    scene.particles.position[1].y = 4.5 * dp;
    const auto engine = scene.engine();
    EXPECT_NEAR(engine->particles().position[1].y, -0.5 * dp, 1e-18);
}

}  // namespace
}  // namespace recoat
