#include "analyzer/fields/pixel_maxima.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace recoat {
namespace {

/// Round-off of a fall that counts as `height`, in pixel sides.
constexpr double tolerance = 1e-7;

/// Floods the distances from the largest down and joins what meets.
class Flood {
public:
    Flood(const PixelDistance& pixels, double height)
        : pixels_(pixels), height_(height), parent_(pixels.squared.size()), top_(pixels.squared.size()) {
        std::iota(parent_.begin(), parent_.end(), 0U);
        std::iota(top_.begin(), top_.end(), 0U);
    }

    std::vector<PixelMaximum> run() {
        std::vector<unsigned> order;
        for (std::size_t p = 0; p < pixels_.squared.size(); ++p) {
            if (pixels_.squared[p] > 0) order.push_back(static_cast<unsigned>(p));
        }
        std::ranges::stable_sort(order, std::ranges::greater{}, [&](unsigned p) { return pixels_.squared[p]; });
        reached_.assign(pixels_.squared.size(), 0);
        falls_.assign(pixels_.squared.size(), -1);
        next_.resize(pixels_.squared.size());
        std::iota(next_.begin(), next_.end(), 0U);
        for (const unsigned p : order) {
            reached_[p] = 1;
            for_each_neighbour(p, [&](unsigned q) {
                if (reached_[q]) join(p, q);
            });
        }
        for (const unsigned p : order) {
            if (find(p) == p) end_dome(top_[p], 0);
        }
        return maxima(order);
    }

private:
    template <class Visit>
    void for_each_neighbour(unsigned p, Visit visit) const {
        const int i = static_cast<int>(p) / pixels_.ny, j = static_cast<int>(p) % pixels_.ny;
        for (int a = std::max(i - 1, 0); a <= std::min(i + 1, pixels_.nx - 1); ++a) {
            for (const int b : {j == 0 ? pixels_.ny - 1 : j - 1, j, j == pixels_.ny - 1 ? 0 : j + 1}) {
                if (a != i || b != j) visit(static_cast<unsigned>(a * pixels_.ny + b));
            }
        }
    }
    unsigned find(unsigned p) {
        while (parent_[p] != p) p = parent_[p] = parent_[parent_[p]];
        return p;
    }
    [[nodiscard]] double distance(unsigned p) const { return std::sqrt(static_cast<double>(pixels_.squared[p])); }

    /// Joins two sets at the level of p. Of tops of different height the lower ends here; equal ones go on together, in
    /// a ring of pixels.
    void join(unsigned p, unsigned q) {
        unsigned a = find(p), b = find(q);
        if (a == b) return;
        if (pixels_.squared[top_[a]] < pixels_.squared[top_[b]]) std::swap(a, b);
        if (pixels_.squared[top_[a]] == pixels_.squared[top_[b]]) {
            std::swap(next_[top_[a]], next_[top_[b]]);
        } else if (top_[b] != p) {
            end_dome(top_[b], distance(p));
        }
        parent_[b] = a;
    }
    void end_dome(unsigned top, double level) {
        const double fall = distance(top) - level;
        unsigned pixel = top;
        do {
            falls_[pixel] = static_cast<float>(fall);
            pixel = next_[pixel];
        } while (pixel != top);
    }

    /// Connected sets of the top pixels that fall far enough.
    std::vector<PixelMaximum> maxima(const std::vector<unsigned>& order) {
        std::vector<PixelMaximum> result;
        const auto counts = [&](unsigned p) { return falls_[p] >= static_cast<float>(height_ - tolerance); };
        std::vector<unsigned> members;
        for (const unsigned seed : order) {
            if (!counts(seed)) continue;
            members.assign(1, seed);
            falls_[seed] = -1;
            double sum = 0;
            for (std::size_t k = 0; k < members.size(); ++k) {
                sum += static_cast<double>(static_cast<int>(members[k]) / pixels_.ny);
                for_each_neighbour(members[k], [&](unsigned q) {
                    if (!counts(q)) return;
                    falls_[q] = -1;
                    members.push_back(q);
                });
            }
            result.push_back({sum / static_cast<double>(members.size()), distance(seed)});
        }
        return result;
    }

    const PixelDistance& pixels_;
    double height_;
    std::vector<unsigned> parent_, top_, next_;
    std::vector<char> reached_;
    std::vector<float> falls_;
};

}  // namespace

std::vector<PixelMaximum> pixel_maxima(const PixelDistance& pixels, double height) {
    if (std::ranges::none_of(pixels.squared, [](std::int64_t value) { return value == 0; })) return {};
    return Flood(pixels, height).run();
}

}  // namespace recoat
