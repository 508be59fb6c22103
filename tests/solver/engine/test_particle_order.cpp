#include <algorithm>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "tests/solver/engine/engine_scenes.hpp"

namespace recoat {
namespace {

using namespace testing;

ParticleTable reordered(const ParticleTable& table, const std::vector<std::size_t>& order) {
    ParticleTable made;
    for (const std::size_t i : order)
        add_particle(made, table.position[i], table.velocity[i], table.angular_velocity[i], table.radius[i]);
    return made;
}

class ParticleOrder : public ::testing::TestWithParam<Variety> {};

// Sums then run in another order: equal to round-off as long as few collisions have blown it up.
TEST_P(ParticleOrder, ChangesNothingPhysical) {
    EngineScene scene = busy_box(GetParam());
    std::vector<std::size_t> order(scene.particles.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::shuffle(order.begin(), order.end(), std::mt19937_64(3));
    EngineScene shuffled = scene;
    shuffled.particles = reordered(scene.particles, order);
    const auto one = scene.engine(), other = shuffled.engine();
    one->advance(150);
    other->advance(150);
    const ParticleTable a = reordered(one->particles(), order), b = other->particles();
    for (std::size_t i = 0; i < a.size(); ++i) {
        ASSERT_LT(norm(a.position[i] - b.position[i]), 1e-9 * dp) << i;
        ASSERT_LT(norm(a.velocity[i] - b.velocity[i]), 1e-7 * 0.1) << i;
        ASSERT_LT(norm(a.angular_velocity[i] - b.angular_velocity[i]), 1e-6 * 4000) << i;
    }
    EXPECT_EQ(one->contacts().size(), other->contacts().size());
    EXPECT_NEAR(one->ledger().dissipated(), other->ledger().dissipated(), 1e-6 * one->ledger().dissipated());
}

TEST_P(ParticleOrder, ContactsAreListedInOrderAndFromTheLowerIndex) {
    const auto engine = busy_box(GetParam()).engine();
    engine->advance(150);
    const auto contacts = engine->contacts();
    const ParticleTable table = engine->particles();
    const double period = 8 * 1.01 * dp;
    ASSERT_GT(contacts.size(), 50u);
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        const ContactState& c = contacts[k];
        const auto pair_of = [](const ContactState& of) { return std::pair(of.first, of.second); };
        EXPECT_TRUE(k == 0 || pair_of(contacts[k - 1]) < pair_of(c));
        EXPECT_NEAR(norm(c.normal), 1, 1e-12);
        EXPECT_NEAR(dot(c.normal, c.tangential_force), 0, 1e-12 * (1e-12 + norm(c.tangential_force)));
        if (c.second < 0) continue;
        EXPECT_LT(c.first, c.second);
        const auto i = static_cast<std::size_t>(c.first), j = static_cast<std::size_t>(c.second);
        Vec3 d = table.position[j] - table.position[i];
        d.y -= period * std::round(d.y / period);
        EXPECT_NEAR(norm(d) - table.radius[i] - table.radius[j], c.separation, 1e-15);
        EXPECT_GT(dot(d, c.normal), 0.999 * norm(d));
    }
}

INSTANTIATE_TEST_SUITE_P(Varieties, ParticleOrder, ::testing::ValuesIn(varieties));

}  // namespace
}  // namespace recoat
