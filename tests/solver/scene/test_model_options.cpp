#include <gtest/gtest.h>

#include "solver/scene/model_options.hpp"
#include "tests/support/scene_text.hpp"

namespace recoat {
namespace {

using testing::scene_of;
using testing::spread_text;

const std::string bond = "cohesion.bond_number=1";

TEST(ModelOptions, DefaultsAreThoseOfTheModel) {
    ContactModel expected;
    const Scene scene = scene_of(spread_text, {bond});
    expected.density = 4430;
    expected.youngs_modulus = 110e9;
    expected.poisson_ratio = 0.3;
    expected.restitution = 0.4;
    expected.sliding_friction = 0.3;
    expected.rolling_friction = 0.01;
    expected.stiffness_ratio = 0.001;
    expected.hamaker = scene.model.hamaker;
    EXPECT_EQ(scene.model, expected);
}

TEST(ModelOptions, EveryValueReachesTheModel) {
    const auto model = [](const std::string& setting) { return scene_of(spread_text, {bond, setting}).model; };
    EXPECT_EQ(model("cohesion.scheme=explicit_force").scheme, CohesionScheme::explicit_force);
    EXPECT_EQ(model("cohesion.scheme=prediction_correction").scheme, CohesionScheme::prediction_correction);
    EXPECT_EQ(model("cohesion.non_contact_hamaker=reduced").non_contact, NonContactHamaker::reduced);
    EXPECT_EQ(model("contact.wall_modulus=rigid").wall_modulus, WallModulus::rigid);
    EXPECT_EQ(model("contact.rolling_length=reduced_radius").rolling_length, RollingLength::reduced_radius);
    EXPECT_EQ(model("contact.rolling_length=diameter").rolling_length, RollingLength::diameter);
    EXPECT_EQ(model("contact.rolling_form=relative").rolling_form, RollingForm::relative);
    EXPECT_EQ(model("contact.lever_arm=radius").lever_arm, LeverArm::radius);
    EXPECT_EQ(model("contact.tangential_damping=none").tangential_damping, TangentialDamping::none);
    EXPECT_FALSE(model("contact.dashpot_cap=false").cap_dashpot);
    EXPECT_TRUE(model("contact.normal_clip=true").clip_normal);
}

TEST(ModelOptions, EveryOptionHasADefaultAndMeanings) {
    for (const ModelOption& option : model_options()) {
        EXPECT_GE(option.values.size(), 2U) << option.key;
        EXPECT_FALSE(option.question.empty()) << option.key;
        for (const OptionValue& value : option.values) EXPECT_FALSE(value.meaning.empty()) << value.name;
    }
}

}  // namespace
}  // namespace recoat
