#include <fstream>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "common/error.hpp"
#include "common/output_file.hpp"
#include "solver/output/summary.hpp"
#include "tests/support/fake_engine.hpp"
#include "tests/support/scene_text.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/throws_message.hpp"

namespace recoat {
namespace {

using ::testing::HasSubstr;

class SummaryFile : public ::testing::Test {
protected:
    nlohmann::json written(const ParticleTable& particles) {
        testing::FakeEngine engine(script_, 2e-8, particles, {});
        engine.advance(10);
        RunProgress progress;
        StageRecord fill;
        fill.name = "fill";
        fill.steps = 10;
        fill.settled = true;
        fill.wall_seconds = 2;
        fill.packing_density = 0.5;
        fill.end.wall_work = 4;
        fill.end.dissipated_normal = 3;
        progress.finished = {fill};
        progress.wall_seconds = 3;
        write_summary(folder_ / "summary.json", scene_, progress, engine, RunStatus::finished, {Backend::cpu, 2, 0});
        std::ifstream file(folder_ / "summary.json");
        return nlohmann::json::parse(file);
    }

    static ParticleTable particles(std::size_t count) {
        ParticleTable table;
        table.position.assign(count, {1e-3, 1e-4, 1e-4});
        table.velocity.resize(count);
        table.angular_velocity.resize(count);
        table.radius.assign(count, 25e-6);
        return table;
    }

    testing::FakeScript script_;
    testing::TemporaryFolder folder_;
    Scene scene_ = testing::scene_of(testing::spread_text, {"cohesion.bond_number=50"});
};

TEST_F(SummaryFile, SaysWhatWasRun) {
    const nlohmann::json json = written(particles(40));
    EXPECT_EQ(json["status"], "finished");
    EXPECT_EQ(json["particles"], 40);
    EXPECT_EQ(json["particles_lost"], 0);
    EXPECT_EQ(json["bond_number"], 50.0);
    EXPECT_EQ(json["config"], scene_.resolved);
    EXPECT_EQ(json["backend"], "openmp");
    EXPECT_EQ(json["threads"], 2);
    const nlohmann::json stage = json["stages"].at(0);
    EXPECT_EQ(stage["name"], "fill");
    EXPECT_EQ(stage["particle_steps_per_second"], 200.0);
    EXPECT_EQ(stage["packing_density"], 0.5);
    EXPECT_EQ(stage["energy"]["balance_error"], -1.0);
    EXPECT_DOUBLE_EQ(stage["energy"]["balance_error_relative"].get<double>(), -1.0 / 7);
    EXPECT_EQ(stage["energy"]["balance_relative_to"], "exchanged");
    EXPECT_EQ(stage["energy"]["balance_scale"], 7.0);
    EXPECT_TRUE(json["energy"].contains("elastic_tangential") && json["energy"].contains("balance_error_relative"));
}

TEST_F(SummaryFile, CountsLostParticles) {
    EXPECT_EQ(written(particles(38))["particles_lost"], 2);
    ParticleTable table = particles(40);
    table.position[3].x = 1;
    table.position[4].z = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(written(table)["particles_lost"], 2);
}

TEST_F(SummaryFile, ReadsBackForTheNextRun) {
    EXPECT_FALSE(read_summary(folder_ / "summary.json"));
    written(particles(40));
    const auto earlier = read_summary(folder_ / "summary.json");
    ASSERT_TRUE(earlier);
    EXPECT_TRUE(earlier->finished);
    EXPECT_EQ(earlier->config, scene_.resolved);
    write_text_file(folder_ / "summary.json", "{\"a\": 1}");
    EXPECT_THAT(testing::message_of<InputError>([&] { (void)read_summary(folder_ / "summary.json"); }),
                HasSubstr("choose another folder"));
}

}  // namespace
}  // namespace recoat
