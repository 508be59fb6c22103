#pragma once

#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <utility>

#include <gtest/gtest.h>

namespace recoat::testing {

/// Expects |error| <= tolerance, and keeps the worst error of the `quantity` in this test as a property of the test,
/// "error tolerance": tests/analytic/verification.py makes docs/verification.md of them. The error is relative unless
/// `quantity` names a unit or says what it is measured in. `where`: the case, for the message.
inline void verify(const std::string& quantity, double error, double tolerance, const std::string& where = "") {
    EXPECT_LE(std::fabs(error), tolerance) << quantity << (where.empty() ? "" : ", ") << where;
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    static std::map<std::pair<const void*, std::string>, double> worst;
    double& share = worst.try_emplace({test, quantity}, -1).first->second;
    if (std::fabs(error) / tolerance <= share) return;
    share = std::fabs(error) / tolerance;
    char text[64];
    std::snprintf(text, sizeof text, "%.1e %g", std::fabs(error), tolerance);
    ::testing::Test::RecordProperty(quantity, text);
}

/// The same for a value that should be `expected`, relative to it.
inline void verify_relative(const std::string& quantity, double found, double expected, double tolerance,
                            const std::string& where = "") {
    verify(quantity, found / expected - 1, tolerance, where);
}

}  // namespace recoat::testing
