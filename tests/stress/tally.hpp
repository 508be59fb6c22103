#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tests/stress/case.hpp"
#include "tests/stress/verdict.hpp"

namespace recoat::stress {

/// Counts of outcomes: of all scenes, by what is special about them, and the ledger errors by step.
class Tally {
public:
    void add(std::uint64_t index, const Case& scene, const Verdict& verdict);

    [[nodiscard]] std::int64_t failures() const { return failures_; }
    /// Why these scenes show little, although each may have ended well: too few came to their end, hardly one met a
    /// fault, or too many were refused. Nothing of fewer than 40 scenes.
    [[nodiscard]] std::optional<std::string> one_sided() const;
    [[nodiscard]] std::string json(std::uint64_t seed) const;
    [[nodiscard]] std::string markdown(std::uint64_t seed) const;

private:
    struct Closing {
        std::uint64_t index;
        double step, error, bound;
    };
    /// Ledger errors of the finished runs whose w dt is in [lower, upper), sorted.
    [[nodiscard]] std::vector<double> errors(double lower, double upper) const;

    [[nodiscard]] std::int64_t count(Outcome outcome) const;

    std::int64_t scenes_ = 0, failures_ = 0;
    std::map<Outcome, std::int64_t> outcomes_;
    std::map<std::string, std::map<Outcome, std::int64_t>> by_character_;
    std::map<std::string, std::int64_t> causes_;
    std::vector<Closing> closings_;
    std::vector<std::string> wrong_;
};

}  // namespace recoat::stress
