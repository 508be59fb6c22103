#include "solver/other_configuration.hpp"

#include <algorithm>
#include <sstream>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "common/config_difference.hpp"

namespace recoat {
namespace {

constexpr std::size_t most = 4;  ///< differences that a sentence names

/// Lines "# content of FILE: fingerprint" that load_scene() adds.
std::vector<std::string> contents(const std::string& config) {
    std::vector<std::string> lines;
    std::istringstream stream(config);
    for (std::string line; std::getline(stream, line);) {
        if (line.starts_with("# content of ")) lines.push_back(line);
    }
    return lines;
}

std::string phrase(const ConfigDifference& difference) {
    const auto value = [](const std::string& text) { return text.empty() ? "absent" : text; };
    return fmt::format("{} is {} there and {} here", difference.key, value(difference.first), value(difference.second));
}

}  // namespace

std::string configuration_differences(const std::string& there, const std::string& here) {
    std::vector<std::string> phrases;
    for (const ConfigDifference& difference : config_differences(there, here)) phrases.push_back(phrase(difference));
    if (phrases.empty() && contents(there) != contents(here))
        phrases.emplace_back("the file that the particles come from has other content");
    if (phrases.empty() && there != here) phrases.emplace_back("they are written differently");
    const std::size_t more = phrases.size() - std::min(phrases.size(), most);
    phrases.resize(phrases.size() - more);
    std::string text = fmt::format("{}", fmt::join(phrases, "; "));
    if (more > 0) text += fmt::format("; and {} more", more);
    return text;
}

}  // namespace recoat
