#include "common/command_line.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "common/config_spelling.hpp"
#include "common/error.hpp"
#include "common/number.hpp"

namespace recoat {
namespace {

std::vector<std::string> commands_of(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(command->get_name());
    return names;
}

std::vector<std::string> options_of(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options([](const CLI::Option*) { return true; })) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    return names;
}

std::string suggestion(const std::vector<std::string>& words, const std::string& wanted) {
    const std::string meant = closest_word(words, wanted);
    return meant.empty() ? "" : fmt::format("; did you mean \"{}\"?", meant);
}

/// The command that was given, or the program itself.
const CLI::App& given_command(const CLI::App& app) {
    const auto given = app.get_subcommands();
    return given.empty() ? app : *given.front();
}

[[noreturn]] void refuse_command(const CLI::App& app, const std::string& word) {
    const std::vector<std::string> commands = commands_of(app);
    if (word.empty())
        throw InputError(fmt::format("a subcommand is missing; give one of {}, and --help after it says more",
                                     fmt::join(commands, ", ")));
    throw InputError(fmt::format("there is no subcommand \"{}\"{} (there are {})", word, suggestion(commands, word),
                                 fmt::join(commands, ", ")));
}

/// The first argument that nothing was made of.
[[noreturn]] void refuse_argument(const CLI::App& app, const std::string& argument) {
    const CLI::App& command = given_command(app);
    const std::string full = &command == &app ? app.get_name() : app.get_name() + " " + command.get_name();
    if (argument.starts_with("-")) {
        const std::string name = argument.substr(0, argument.find('='));
        const std::string meant = suggestion(options_of(command), name);
        throw InputError(fmt::format("{} has no option {}{}", full, name,
                                     meant.empty() ? "; " + full + " --help lists them" : meant));
    }
    throw InputError(fmt::format("\"{}\" is one argument too many for {}; quote names with blanks, and see {} --help",
                                 argument, full, full));
}

void refuse_what_was_left(const CLI::App& app) {
    std::vector<std::string> left = app.remaining(true);
    if (left.empty()) return;
    // CLI11 may give them backwards: the option before its value.
    const auto option = std::ranges::find_if(left, [](const std::string& word) { return word.starts_with("-"); });
    refuse_argument(app, option == left.end() ? left.front() : *option);
}

}  // namespace

CLI::Validator whole_number(std::int64_t lower, std::int64_t upper) {
    const std::string range = upper == std::numeric_limits<std::int64_t>::max()
                                  ? fmt::format("{} or more", lower)
                                  : fmt::format("from {} to {}", lower, upper);
    const auto check = [=](const std::string& text) {
        const std::optional<std::int64_t> number = parse_integer(text);
        if (number && *number >= lower && *number <= upper) return std::string();
        return fmt::format("\"{}\" is no whole number {}", text, range);
    };
    return {check, range};
}

std::optional<int> parse_command_line(CLI::App& app, int argc, const char* const* argv) {
    const std::string first = argc > 1 ? argv[1] : "";
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp& request) {
        return app.exit(request);
    } catch (const CLI::CallForVersion& request) {
        return app.exit(request);
    } catch (const CLI::ParseError& error) {
        if (app.get_subcommands().empty() && !first.starts_with("-")) refuse_command(app, first);
        refuse_what_was_left(app);
        const CLI::App& command = given_command(app);
        throw InputError(fmt::format("{}; {}{}{} --help says more", error.what(), app.get_name(),
                                     &command == &app ? "" : " ", &command == &app ? "" : command.get_name()));
    }
    return {};
}

}  // namespace recoat
