#include <cmath>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "common/number.hpp"
#include "common/output_file.hpp"
#include "solver/scene/automatic_time_step.hpp"
#include "solver/scene/time_step_limits.hpp"
#include "tests/support/scene_text.hpp"
#include "tests/support/temporary_folder.hpp"

namespace recoat {
namespace {

using ::testing::HasSubstr;
using testing::scene_of;
using testing::spread_text;

/// The scene of the tests at an automatic step.
Scene automatic(const std::string& bond, const std::string& ratio) {
    return scene_of(spread_text, {"time_step=auto", "cohesion.bond_number=" + bond, "stiffness_ratio=" + ratio});
}

TEST(AutomaticTimeStep, is_taken_when_none_is_given) {
    std::string text = spread_text;
    const std::string given = "time_step: 2e-8 s\n";
    text.erase(text.find(given), given.size());
    const Scene scene = scene_of(text);
    EXPECT_EQ(scene.time_step_choice, TimeStepChoice::automatic);
    EXPECT_EQ(scene.time_step, chosen_time_step(scene, TimeStepChoice::automatic));
    EXPECT_EQ(scene_of(spread_text).time_step_choice, TimeStepChoice::given);
    EXPECT_EQ(scene_of(spread_text).time_step, 2e-8);
}

// A run that goes on later, with another version of the program, must not take another step.
TEST(AutomaticTimeStep, stands_in_the_resolved_configuration) {
    const Scene scene = automatic("5", "0.001");
    const Scene again = scene_of(scene.resolved);
    EXPECT_EQ(again.time_step_choice, TimeStepChoice::given);
    EXPECT_EQ(again.time_step, scene.time_step);
    EXPECT_EQ(again.resolved, scene.resolved);
}

// docs/physics.md section 2.1: times of a contact go with the stiffness ratio to the power -2/5.
TEST(AutomaticTimeStep, goes_with_the_contact_time) {
    const double step = automatic("0", "0.001").time_step;
    for (const auto& [ratio, factor] : {std::pair{"1", 0.0631}, {"0.1", 0.158}, {"0.01", 0.398}, {"0.0001", 2.512}})
        EXPECT_NEAR(automatic("0", ratio).time_step / (factor * step), 1, 0.1) << ratio;
}

// A particle crosses s_min in a time that goes with the attraction to the power -1/2, whatever the stiffness.
TEST(AutomaticTimeStep, is_bounded_by_strong_attraction) {
    const double strong = automatic("4000", "0.001").time_step;
    EXPECT_LT(strong, 0.5 * automatic("0", "0.001").time_step);
    EXPECT_NEAR(automatic("16000", "0.001").time_step / strong, 0.5, 0.03);
    EXPECT_EQ(automatic("4000", "0.0001").time_step, strong);
}

TEST(AutomaticTimeStep, is_that_of_the_smallest_sphere_of_a_table) {
    const testing::TemporaryFolder folder;
    const auto step = [&](const std::string& radius) {
        write_text_file(folder / "two.csv", "x,y,z,radius,vx,vy,vz,wx,wy,wz\n0,0,0,25e-6,0,0,0,0,0,0\n0,0,2e-4," +
                                                radius + ",0,0,0,0,0,0\n");
        write_text_file(folder / "scene.yaml", "scene: particles\n" + testing::model_text +
                                                   "particles: two.csv\nduration: 1 ms\nstiffness_ratio: 0.001\n");
        return load_scene(folder / "scene.yaml", std::vector<std::string>{"time_step=auto"}).time_step;
    };
    // Contact times go with the radius.
    EXPECT_NEAR(step("5e-6") / step("25e-6"), 0.2, 0.01);
}

/// What `make bench-accuracy` found.
nlohmann::json measured(const char* part) {
    return nlohmann::json::parse(std::ifstream(RECOAT_ACCURACY)).at("recommended").at(part);
}

// docs/accuracy.md: about half of the longest steps that keep the capture velocity to 1 % in the worst phase.
TEST(AutomaticTimeStep, keeps_the_capture_velocity_at_every_ratio) {
    const nlohmann::json rows = measured("two_body");
    ASSERT_FALSE(rows.empty());
    for (const auto& row : rows) {
        const Scene scene =
            automatic(std::to_string(row.at("bond").get<double>()), std::to_string(row.at("ratio").get<double>()));
        EXPECT_LE(scene.time_step, 0.65 * row.at("longest_step").get<double>()) << row;
    }
}

// And of those at which beds and layers cannot be told from those of shorter steps; not needlessly short either.
TEST(AutomaticTimeStep, keeps_beds_and_layers) {
    const nlohmann::json rows = measured("powder");
    ASSERT_FALSE(rows.empty());
    for (const auto& row : rows) {
        const Scene scene = automatic(std::to_string(row.at("bond").get<double>()), "0.001");
        EXPECT_LE(scene.time_step, 0.65 * row.at("longest_step").get<double>()) << row;
        EXPECT_GT(scene.time_step, 0.2 * row.at("longest_step").get<double>()) << row;
    }
}

/// The scene of the tests at a fast step.
Scene fast(const std::string& bond, const std::string& ratio) {
    return scene_of(spread_text, {"time_step=fast", "cohesion.bond_number=" + bond, "stiffness_ratio=" + ratio});
}

// docs/accuracy.md: the longest steps whose beds and layers nothing tells from those of shorter ones.
TEST(FastTimeStep, keeps_beds_and_layers) {
    const nlohmann::json rows = measured("powder");
    ASSERT_FALSE(rows.empty());
    for (const auto& row : rows) {
        const Scene scene = fast(std::to_string(row.at("bond").get<double>()), "0.001");
        EXPECT_LE(scene.time_step, row.at("longest_step").get<double>()) << row;
    }
}

TEST(FastTimeStep, is_longer_than_the_automatic_one) {
    for (const char* bond : {"0", "5", "100", "400", "900"})
        for (const char* ratio : {"1", "0.001", "0.0001"}) {
            const Scene scene = fast(bond, ratio);
            EXPECT_GT(scene.time_step, 1.4 * automatic(bond, ratio).time_step) << bond << ' ' << ratio;
            EXPECT_EQ(scene.time_step_choice, TimeStepChoice::fast);
        }
}

TEST(AutomaticTimeStep, has_two_digits) {
    for (const char* bond : {"0", "5", "100", "200", "300", "400", "1000"})
        EXPECT_LE(shortest(automatic(bond, "0.001").time_step).size(), std::string("7.2e-08").size()) << bond;
}

TEST(AutomaticTimeStep, refuses_other_words) {
    EXPECT_THROW(scene_of(spread_text, {"time_step=automatic"}), std::exception);
}

}  // namespace
}  // namespace recoat
