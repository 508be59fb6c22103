#include <cmath>
#include <functional>
#include <random>

#include <gtest/gtest.h>

#include "analyzer/fields/sort_in_pieces.hpp"

namespace recoat {
namespace {

struct Item {
    double number;
    std::size_t index;

    friend bool operator==(const Item&, const Item&) = default;
    friend bool operator<(const Item& a, const Item& b) {
        return a.number != b.number ? a.number < b.number : a.index < b.index;
    }
};

void expect_sorted_as_by_std(const std::vector<double>& numbers) {
    std::vector<Item> items;
    for (const double number : numbers) items.push_back({number, items.size() * 7919 % numbers.size()});
    std::vector<Item> expected = items;
    std::ranges::sort(expected, std::less<>{});
    sort_in_pieces(items, std::mem_fn(&Item::number), std::less<>{});
    EXPECT_EQ(items, expected);
}

TEST(SortInPieces, SameAsSortingAtOnce) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> even(-3, 5);
    for (const std::size_t count : {0, 1, 2, 2047, 2048, 2049, 100'000}) {
        std::vector<double> numbers(count);
        for (double& number : numbers) number = even(random);
        expect_sorted_as_by_std(numbers);
        for (double& number : numbers) number = std::exp(20 * number);  // nearly all in the first cell
        expect_sorted_as_by_std(numbers);
        for (double& number : numbers) number = std::floor(even(random));  // eight numbers only
        expect_sorted_as_by_std(numbers);
        for (double& number : numbers) number = 0.25;
        expect_sorted_as_by_std(numbers);
    }
}

}  // namespace
}  // namespace recoat
