#include <gtest/gtest.h>

#include "solver/contact/coefficients.hpp"
#include "tests/support/paper_model.hpp"

namespace recoat {
namespace {

using testing::paper_model;
using testing::paper_radius;

void expect_alike(const Coefficients& a, const Coefficients& b, double tolerance) {
    const auto near = [&](double Coefficients::*number) {
        EXPECT_NEAR(a.*number, b.*number, tolerance * std::fabs(b.*number));
    };
    near(&Coefficients::hertz);
    near(&Coefficients::normal_damping);
    near(&Coefficients::tangential_damping);
    near(&Coefficients::inverse_mass);
    near(&Coefficients::attraction_gap);
    near(&Coefficients::attraction_contact);
    near(&Coefficients::attraction_friction);
    near(&Coefficients::rolling_length);
}

TEST(Coefficients, EqualRadiiAreASpecialCaseOfAny) {
    for (const RollingForm form : {RollingForm::own, RollingForm::relative})
        for (const RollingLength length :
             {RollingLength::radius, RollingLength::reduced_radius, RollingLength::diameter}) {
            ContactModel model = paper_model(0.001, 50);
            model.rolling_form = form;
            model.rolling_length = length;
            const EqualSizes equal = equal_sizes(model, paper_radius);
            const AnySizes any = any_sizes(model);
            expect_alike(equal.pair, any.of_pair(paper_radius, paper_radius), 1e-14);
            expect_alike(equal.wall, any.of_wall(paper_radius), 1e-14);
            EXPECT_DOUBLE_EQ(equal.mass, any.mass_of(paper_radius));
            EXPECT_DOUBLE_EQ(equal.inverse_inertia, any.inverse_inertia_of(paper_radius));
        }
}

TEST(Coefficients, AWallIsAnInfinitePartner) {
    const AnySizes any = any_sizes(paper_model(0.001, 50));
    expect_alike(any.of_pair(paper_radius, 1e8 * paper_radius), any.of_wall(paper_radius), 3e-8);
    expect_alike(any.of_pair(1e8 * paper_radius, paper_radius), any.of_wall(paper_radius), 3e-8);
}

TEST(Coefficients, APairHasNoOrder) {
    const AnySizes any = any_sizes(paper_model(0.001, 50));
    expect_alike(any.of_pair(20e-6, 35e-6), any.of_pair(35e-6, 20e-6), 1e-15);
}

// A rigid wall doubles E* and G*: k_H doubles, the dashpots grow by sqrt 2, the attraction stays.
TEST(Coefficients, RigidWalls) {
    ContactModel model = paper_model(0.001, 50);
    const Coefficients elastic = equal_sizes(model, paper_radius).wall;
    model.wall_modulus = WallModulus::rigid;
    const EqualSizes rigid = equal_sizes(model, paper_radius);
    EXPECT_NEAR(rigid.wall.hertz / elastic.hertz, 2, 1e-14);
    EXPECT_NEAR(rigid.wall.normal_damping / elastic.normal_damping, std::sqrt(2), 1e-14);
    EXPECT_NEAR(rigid.wall.tangential_damping / elastic.tangential_damping, std::sqrt(2), 1e-14);
    EXPECT_DOUBLE_EQ(rigid.wall.attraction_gap, elastic.attraction_gap);
    EXPECT_NEAR(elastic.hertz / rigid.pair.hertz, std::sqrt(2), 1e-14);
}

// A^O out of contact, A^R in it; friction always sees the original [docs/physics.md section 2.3].
TEST(Coefficients, HamakerConstantsInAndOutOfContact) {
    ContactModel model = paper_model(0.001, 50);
    const double pull_off = 50 * 2.844339083698e-9;
    const Coefficients original = equal_sizes(model, paper_radius).pair;
    EXPECT_NEAR(original.attraction_gap, pull_off, 1e-12 * pull_off);
    EXPECT_NEAR(original.attraction_contact, 0.06309573444801932 * pull_off, 1e-12 * pull_off);
    EXPECT_NEAR(original.attraction_friction, pull_off, 1e-12 * pull_off);
    model.non_contact = NonContactHamaker::reduced;
    const Coefficients reduced = equal_sizes(model, paper_radius).pair;
    EXPECT_DOUBLE_EQ(reduced.attraction_gap, original.attraction_contact);
    EXPECT_DOUBLE_EQ(reduced.attraction_friction, original.attraction_friction);
}

// The torque of rolling is mu_r times: R (default), R*, or 2R; the particle multiplies by its radius in the own form.
TEST(Coefficients, RollingLengths) {
    const auto lengths = [](RollingForm form, RollingLength length) {
        ContactModel model = paper_model(0.001, 0);
        model.rolling_form = form;
        model.rolling_length = length;
        const EqualSizes sizes = equal_sizes(model, paper_radius);
        return std::pair{sizes.pair.rolling_length, sizes.wall.rolling_length};
    };
    const double r = paper_radius;
    EXPECT_EQ(lengths(RollingForm::own, RollingLength::radius), (std::pair{1.0, 1.0}));
    EXPECT_EQ(lengths(RollingForm::own, RollingLength::diameter), (std::pair{1.0, 1.0}));
    EXPECT_EQ(lengths(RollingForm::own, RollingLength::reduced_radius), (std::pair{r / 2, r}));
    EXPECT_EQ(lengths(RollingForm::relative, RollingLength::radius), (std::pair{r, r}));
    EXPECT_EQ(lengths(RollingForm::relative, RollingLength::reduced_radius), (std::pair{r / 2, r}));
    EXPECT_EQ(lengths(RollingForm::relative, RollingLength::diameter), (std::pair{2 * r, 2 * r}));
}

TEST(Coefficients, TangentialDashpotCanBeLeftOut) {
    ContactModel model = paper_model(0.001, 0);
    model.tangential_damping = TangentialDamping::none;
    const EqualSizes sizes = equal_sizes(model, paper_radius);
    EXPECT_EQ(sizes.pair.tangential_damping, 0);
    EXPECT_GT(sizes.pair.normal_damping, 0);
}

}  // namespace
}  // namespace recoat
