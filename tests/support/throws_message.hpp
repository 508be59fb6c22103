#pragma once

#include <string>

#include <gtest/gtest.h>

namespace recoat::testing {

/// Message of the `Error` that `action` throws; a failed test if it throws nothing or something else.
template <class Error, class Action>
std::string message_of(const Action& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    } catch (const std::exception& error) {
        ADD_FAILURE() << "another exception was thrown: " << error.what();
        return {};
    }
    ADD_FAILURE() << "nothing was thrown";
    return {};
}

}  // namespace recoat::testing
