#include <gtest/gtest.h>

#include "common/units.hpp"
#include "tests/support/throws_message.hpp"

namespace recoat {
namespace {

using testing::message_of;

struct Written {
    const char* text;
    Dimension dimension;
    double value;
};

class Quantity : public ::testing::TestWithParam<Written> {};

TEST_P(Quantity, IsItsValueInSi) {
    const auto [text, dimension, value] = GetParam();
    EXPECT_EQ(parse_quantity(text, dimension), value) << text;
}

// The values on the right are decimal numbers: the unit must not cost a last bit.
INSTANTIATE_TEST_SUITE_P(
    Units, Quantity,
    ::testing::Values(Written{"42", Dimension::none, 42}, Written{"50 um", Dimension::length, 50e-6},
                      Written{"50um", Dimension::length, 50e-6}, Written{"  50   um ", Dimension::length, 50e-6},
                      Written{"50 µm", Dimension::length, 50e-6}, Written{"50 μm", Dimension::length, 50e-6},
                      Written{"50 micron", Dimension::length, 50e-6}, Written{"3 \u00B5s", Dimension::time, 3e-6},
                      Written{"3 \u03BCs", Dimension::time, 3e-6}, Written{"9 \u00B5m/s", Dimension::speed, 9e-6},
                      Written{"9 \u03BCm/s", Dimension::speed, 9e-6}, Written{"2 \u00B5J", Dimension::energy, 2e-6},
                      Written{"2 \u03BCJ", Dimension::energy, 2e-6}, Written{"3 \u00B5N", Dimension::force, 3e-6},
                      Written{"3 \u03BCN", Dimension::force, 3e-6}, Written{"0.165 nm", Dimension::length, 0.165e-9},
                      Written{"7 mm", Dimension::length, 7e-3}, Written{"7 cm", Dimension::length, 7e-2},
                      Written{"-.5 m", Dimension::length, -0.5}, Written{"2e-8 s", Dimension::time, 2e-8},
                      Written{"20 ns", Dimension::time, 20e-9}, Written{"3 us", Dimension::time, 3e-6},
                      Written{"5 ms", Dimension::time, 5e-3}, Written{"2 min", Dimension::time, 120},
                      Written{"50 mm/s", Dimension::speed, 50e-3}, Written{"1 cm/s", Dimension::speed, 1e-2},
                      Written{"9 um/s", Dimension::speed, 9e-6}, Written{"1 m/s", Dimension::speed, 1},
                      Written{"9.81 m/s2", Dimension::acceleration, 9.81},
                      Written{"9.81 m/s^2", Dimension::acceleration, 9.81},
                      Written{"4430 kg/m3", Dimension::density, 4430}, Written{"4.43 g/cm3", Dimension::density, 4430},
                      Written{"110 GPa", Dimension::pressure, 110e9}, Written{"3 MPa", Dimension::pressure, 3e6},
                      Written{"3 kPa", Dimension::pressure, 3e3}, Written{"3 Pa", Dimension::pressure, 3},
                      Written{"1e-20 J", Dimension::energy, 1e-20}, Written{"10 zJ", Dimension::energy, 1e-20},
                      Written{"3 aJ", Dimension::energy, 3e-18}, Written{"1 eV", Dimension::energy, 1.602176634e-19},
                      Written{"1 rad", Dimension::angle, 1}, Written{"180 deg", Dimension::angle, 3.141592653589793},
                      Written{"2 rad/s", Dimension::angular_velocity, 2}, Written{"3 uN", Dimension::force, 3e-6},
                      Written{"3 N", Dimension::force, 3}));

TEST(QuantityInTurns, IsTwoPiPerTurnToRoundOff) {
    EXPECT_DOUBLE_EQ(parse_quantity("60 rpm", Dimension::angular_velocity), 6.283185307179586);
    EXPECT_DOUBLE_EQ(parse_quantity("90 deg", Dimension::angle), 1.5707963267948966);
    EXPECT_DOUBLE_EQ(parse_quantity("90 deg/s", Dimension::angular_velocity), 1.5707963267948966);
}

TEST(QuantityInDiameters, NeedsADiameter) {
    EXPECT_EQ(parse_quantity("1.5 dp", Dimension::length, 0.25), 0.375);
    EXPECT_NE(message_of<UnitError>([] { parse_quantity("1.5 dp", Dimension::length); }).find("particle diameter"),
              std::string::npos);
    EXPECT_THROW(parse_quantity("1.5 dp", Dimension::time, 50e-6), UnitError);
}

TEST(QuantityWithoutUnit, IsRefusedUnlessZeroOrAllowed) {
    EXPECT_EQ(message_of<UnitError>([] { parse_quantity("50", Dimension::length); }),
              "\"50\" has no unit; a length is wanted: use one of m, cm, mm, um, nm");
    EXPECT_EQ(parse_quantity("0", Dimension::length), 0);
    EXPECT_EQ(parse_quantity("50", Dimension::length, {}, true), 50);
}

TEST(QuantityOfWrongDimension, NamesBoth) {
    EXPECT_EQ(message_of<UnitError>([] { parse_quantity("50 s", Dimension::length); }),
              "\"s\" is the unit of a time, but a length is wanted; use one of m, cm, mm, um, nm");
    EXPECT_EQ(message_of<UnitError>([] { parse_quantity("50 furlong", Dimension::length, 1.0); }),
              "\"furlong\" is no unit of a length; use one of m, cm, mm, um, nm, dp");
    EXPECT_THROW(parse_quantity("50 m", Dimension::none), UnitError);
    EXPECT_THROW(parse_quantity("50 UM", Dimension::length), UnitError);
}

TEST(QuantityThatIsNoFiniteNumber, IsRefused) {
    for (const auto* text : {"", "um", "nan m", "inf m", "fast", "1e400 m"}) {
        EXPECT_THROW(parse_quantity(text, Dimension::length), UnitError) << text;
    }
}

}  // namespace
}  // namespace recoat
