#include "common/config_spelling.hpp"

#include <algorithm>

namespace recoat {
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before, previous, current(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) current[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before = std::move(previous);
        previous = std::move(current);
        current.assign(b.size() + 1, i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = previous[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            current[j] = std::min({previous[j] + 1, current[j - 1] + 1, replaced});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) current[j] = std::min(current[j], before[j - 2] + 1);
        }
    }
    return current.back();
}

std::string closest_word(const std::vector<std::string>& words, std::string_view wanted) {
    // "bond_numer" is close, "density" and "diameter" are not.
    std::size_t best = std::max<std::size_t>(1, wanted.size() / 3) + 1;
    std::string found;
    for (const std::string& word : words) {
        const std::size_t distance = edit_distance(word, wanted);
        if (distance < best) {
            best = distance;
            found = word;
        }
    }
    return found;
}

std::string closest_unknown(const ConfigNode& node, std::string_view wanted) {
    std::vector<std::string> unknown;
    for (const auto& [key, value] : node.entries) {
        if (!node.asked.contains(key)) unknown.push_back(key);
    }
    return closest_word(unknown, wanted);
}

std::string closest_known(const ConfigNode& node, std::string_view unknown) {
    return closest_word({node.asked.begin(), node.asked.end()}, unknown);
}

}  // namespace recoat
