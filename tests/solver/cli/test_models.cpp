#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solver/cli/models.hpp"

namespace recoat {
namespace {

using ::testing::HasSubstr;

TEST(Models, NamesEachOptionAndMarksTheDefault) {
    const std::string text = models_text();
    EXPECT_THAT(text, HasSubstr("contact.wall_modulus: "));
    EXPECT_THAT(text, HasSubstr("cohesion.scheme: "));
    EXPECT_THAT(text, HasSubstr("path of the step (default)"));
    EXPECT_THAT(text, HasSubstr("prediction_correction"));
}

}  // namespace
}  // namespace recoat
