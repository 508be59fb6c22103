#pragma once

#include <cstdlib>

#include <gtest/gtest.h>

namespace recoat::testing {

/// Fails unless a sanitizer ends the program in `action`, or after it at its end, and says `what`. Once per test.
template <class Action>
void expect_finding(const Action& action, const char* what) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    const auto program = [&] {
        action();
        std::exit(0);
    };
    EXPECT_EXIT(
        program(), [](int status) { return status != 0; }, what);
}

}  // namespace recoat::testing
