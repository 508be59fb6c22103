#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace recoat {

/// The user's input is wrong. The message is one whole sentence: what is wrong, where, what to do. Exit code 2.
struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The simulation cannot go on. The message is one whole sentence: what happened, where, why. Exit code 3.
struct SimulationFault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// How a program, or one of the tasks of a program, ended.
struct Ending {
    int code = 0;          ///< exit code
    std::string sentence;  ///< of the exception that ended it; else empty
};

/// Runs `body`. The code is that of the body, 2 after InputError, 3 after SimulationFault, 1 after any other exception,
/// which is a bug.
Ending ending_of(const std::function<int()>& body) noexcept;

/// Runs the body of `program` and returns the exit code as ending_of does. Errors go to standard error as
/// "program: error: sentence".
int run_program(std::string_view program, const std::function<int()>& body) noexcept;

/// Writes "program: warning: sentence" to standard error: what the user should know although all went well.
void warn(std::string_view program, std::string_view sentence) noexcept;

}  // namespace recoat
