#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

namespace recoat {

/// Checks that an argument is a whole number between two bounds, both included, and says so where it is none.
CLI::Validator whole_number(std::int64_t lower, std::int64_t upper = std::numeric_limits<std::int64_t>::max());

/// Parses the command line of a program whose commands are subcommands of `app`. Returns the exit code where there is
/// nothing more to do, after --help and --version. Throws InputError with one sentence for anything that is wrong; a
/// misspelt command or option is told what it may be meant to be.
std::optional<int> parse_command_line(CLI::App& app, int argc, const char* const* argv);

}  // namespace recoat
