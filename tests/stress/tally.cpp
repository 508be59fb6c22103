#include "tests/stress/tally.hpp"

#include <algorithm>
#include <array>
#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace recoat::stress {
namespace {

constexpr std::array<double, 8> step_edges = {0, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 1e300};

/// The first words of a sentence that say what happened.
std::string cause_of(const std::string& sentence) {
    constexpr std::array<std::pair<const char*, const char*>, 9> causes = {{
        {" overlaps ", "overlap beyond the contact law"},
        {"would be faster", "faster than a contact can be followed"},
        {"energy", "energy not accounted for"},
        {"has left the domain", "left the domain"},
        {"stability limit", "step beyond the stability limit"},
        {"period", "period too short"},
        {"no particles", "no particles"},
        {"spins", "spins too fast"},
        {"cut_off", "attraction too far for the smallest"},
    }};
    for (const auto& [words, cause] : causes) {
        if (sentence.find(words) != std::string::npos) return cause;
    }
    return "another: " + sentence.substr(sentence.find_last_of('/') + 1, 60);
}

double quantile(const std::vector<double>& sorted, double share) {
    return sorted.empty() ? 0 : sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

}  // namespace

void Tally::add(std::uint64_t index, const Case& scene, const Verdict& verdict) {
    ++scenes_;
    ++outcomes_[verdict.outcome];
    std::stringstream words(scene.character);
    for (std::string word; std::getline(words >> std::ws, word, ',');) ++by_character_[word][verdict.outcome];
    if (verdict.outcome == Outcome::stopped || verdict.outcome == Outcome::refused)
        ++causes_[name_of(verdict.outcome) + ": " + cause_of(verdict.reason)];
    if (verdict.outcome == Outcome::finished || verdict.outcome == Outcome::open_ledger)
        closings_.push_back({index, verdict.step, verdict.ledger_error, verdict.ledger_bound});
    if (is_right(verdict.outcome)) return;
    ++failures_;
    wrong_.push_back(fmt::format("scene {}: {}: {}", index, name_of(verdict.outcome), verdict.reason));
}

std::vector<double> Tally::errors(double lower, double upper) const {
    std::vector<double> found;
    for (const Closing& each : closings_) {
        if (each.step >= lower && each.step < upper) found.push_back(each.error);
    }
    std::ranges::sort(found);
    return found;
}

std::int64_t Tally::count(Outcome outcome) const {
    const auto found = outcomes_.find(outcome);
    return found == outcomes_.end() ? 0 : found->second;
}

// Of 2400 scenes 45 % finish, 30 % stop and 25 % are refused: of 40, by chance, each bound is passed once in a thousand
// draws or less often.
std::optional<std::string> Tally::one_sided() const {
    if (scenes_ < 40) return {};
    const auto sentence = [&](Outcome outcome, const char* limit) {
        return fmt::format("{} of {} scenes {}, {} expected: the draw, or what refuses scenes, has gone astray",
                           count(outcome), scenes_, name_of(outcome), limit);
    };
    if (5 * count(Outcome::finished) < scenes_) return sentence(Outcome::finished, "a fifth at least");
    if (12 * count(Outcome::stopped) < scenes_) return sentence(Outcome::stopped, "a twelfth at least");
    if (2 * count(Outcome::refused) > scenes_) return sentence(Outcome::refused, "half at most");
    return {};
}

std::string Tally::json(std::uint64_t seed) const {
    nlohmann::ordered_json json = {{"seed", seed}, {"scenes", scenes_}, {"failures", failures_}};
    for (const auto& [outcome, count] : outcomes_) json["outcomes"][name_of(outcome)] = count;
    for (const auto& [cause, count] : causes_) json["causes"][cause] = count;
    for (const auto& [character, outcomes] : by_character_) {
        for (const auto& [outcome, count] : outcomes) json["by_character"][character][name_of(outcome)] = count;
    }
    for (const Closing& each : closings_)
        json["ledgers"].push_back(
            {{"scene", each.index}, {"step", each.step}, {"error", each.error}, {"bound", each.bound}});
    json["wrong"] = wrong_;
    return json.dump(1) + "\n";
}

std::string Tally::markdown(std::uint64_t seed) const {
    std::string text = fmt::format("{} scenes, seed {}:\n\n| outcome | scenes |\n|---|---|\n", scenes_, seed);
    for (int k = 0; k <= static_cast<int>(Outcome::open_ledger); ++k) {
        const auto outcome = static_cast<Outcome>(k);
        text += fmt::format("| {} | {} |\n", name_of(outcome), count(outcome));
    }
    text += "\n| why it stopped | scenes |\n|---|---|\n";
    for (const auto& [cause, count] : causes_) text += fmt::format("| {} | {} |\n", cause, count);
    text += "\n| w dt | scenes | median error of the ledger | 90 % | 99 % | largest |\n|---|---|---|---|---|---|\n";
    for (std::size_t k = 0; k + 1 < step_edges.size(); ++k) {
        const std::vector<double> found = errors(step_edges[k], step_edges[k + 1]);
        if (found.empty()) continue;
        text +=
            fmt::format("| {:g} to {:g} | {} | {:.1e} | {:.1e} | {:.1e} | {:.1e} |\n", step_edges[k], step_edges[k + 1],
                        found.size(), quantile(found, 0.5), quantile(found, 0.9), quantile(found, 0.99), found.back());
    }
    for (const std::string& each : wrong_) text += "\n- " + each;
    return text;
}

}  // namespace recoat::stress
