#include "analyzer/fields/greedy_circles.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>

namespace recoat {
namespace {

/// Circles whose radii differ by less may come in the order of their places [d_p].
constexpr double rounding = 1e-8;

/// A circle and its place in the order of selection.
struct Ranked {
    Circle circle;
    std::size_t rank = 0;
};

/// Circles with radii within a factor of two, sorted by cells: about one circle in each.
class SizeClass {
public:
    SizeClass(const std::vector<Circle>& circles, std::size_t begin, std::size_t end, double period)
        : first_slot_(begin), largest_(circles[begin]) {
        const auto [left, right] = std::ranges::minmax(std::span(circles).subspan(begin, end - begin), {}, &Circle::x);
        largest_.radius += rounding;
        x_min_ = left.x;
        x_max_ = right.x;
        const double length = x_max_ - x_min_, count = static_cast<double>(end - begin);
        side_ = std::max({std::sqrt(length * period / count), length / count, period / count}) * (1 + 1e-9);
        nx_ = std::max<std::int64_t>(1, static_cast<std::int64_t>(length / side_));
        ny_ = std::max<std::int64_t>(1, static_cast<std::int64_t>(period / side_));
        per_x_ = length > 0 ? static_cast<double>(nx_) / length : 0;
        per_y_ = static_cast<double>(ny_) / period;
        sort(circles, begin, end);
    }

    /// Visits the slots of circles that come before `rank`, among them all with centres within `distance` of a place,
    /// until visit(slot) says no.
    template <class Visit>
    void visit_near(const Circle& place, double distance, std::size_t rank, Visit visit) const {
        distance += rounding * side_;
        if (place.x < x_min_ - distance || place.x > x_max_ + distance) return;
        const auto below = static_cast<std::int64_t>(std::floor((place.y - distance) * per_y_));
        const auto above = static_cast<std::int64_t>(std::floor((place.y + distance) * per_y_));
        const std::int64_t rows = std::min(above - below + 1, ny_), lowest = (below % ny_ + ny_) % ny_;
        const std::int64_t last = column(place.x + distance);
        for (std::int64_t a = column(place.x - distance); a <= last; ++a) {
            for (std::int64_t k = 0, b = lowest; k < rows; ++k, b = b + 1 < ny_ ? b + 1 : 0) {
                const auto cell = static_cast<std::size_t>(a * ny_ + b);
                for (std::size_t s = start_[cell]; s < start_[cell + 1] && sorted_[s].rank < rank; ++s) {
                    if (!visit(first_slot_ + s)) return;
                }
            }
        }
    }
    /// At least as large as any.
    [[nodiscard]] const Circle& largest() const { return largest_; }
    [[nodiscard]] const std::vector<Ranked>& sorted() const { return sorted_; }

private:
    void sort(const std::vector<Circle>& circles, std::size_t begin, std::size_t end) {
        start_.assign(static_cast<std::size_t>(nx_ * ny_) + 1, 0);
        for (std::size_t k = begin; k < end; ++k) ++start_[cell_of(circles[k]) + 1];
        std::partial_sum(start_.begin(), start_.end(), start_.begin());
        std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
        sorted_.resize(end - begin);
        for (std::size_t k = begin; k < end; ++k) sorted_[next[cell_of(circles[k])]++] = {circles[k], k};
    }
    [[nodiscard]] std::size_t cell_of(const Circle& circle) const {
        return static_cast<std::size_t>(column(circle.x) * ny_ + row(circle.y));
    }
    [[nodiscard]] std::int64_t column(double x) const {
        return std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor((x - x_min_) * per_x_)), 0, nx_ - 1);
    }
    [[nodiscard]] std::int64_t row(double y) const {
        return std::clamp<std::int64_t>(static_cast<std::int64_t>(y * per_y_), 0, ny_ - 1);
    }

    std::size_t first_slot_;
    Circle largest_;
    double x_min_ = 0, x_max_ = 0, side_ = 1, per_x_ = 0, per_y_ = 0;
    std::int64_t nx_ = 1, ny_ = 1;
    std::vector<std::size_t> start_;
    std::vector<Ranked> sorted_;
};

/// A circle is selected when none is that it meets and that comes before it. So each can be decided from those near it:
/// place by place, in any order, with the same result as from the first to the last.
class Selection {
public:
    Selection(const std::vector<Circle>& circles, double period, CircleRule rule) : period_(period), rule_(rule) {
        constexpr int most_classes = 12;
        for (std::size_t begin = 0; begin < circles.size();) {
            const double lowest = classes_.size() + 1 < most_classes ? circles[begin].radius / 2 : 0;
            std::size_t end = begin + 1;
            while (end < circles.size() && circles[end].radius > lowest) ++end;
            classes_.emplace_back(circles, begin, end, period);
            const std::vector<Ranked>& sorted = classes_.back().sorted();
            slots_.insert(slots_.end(), sorted.begin(), sorted.end());
            class_of_.insert(class_of_.end(), sorted.size(), static_cast<char>(classes_.size() - 1));
            begin = end;
        }
        state_.assign(circles.size(), State::open);
    }

    /// Whether each of the circles is selected.
    std::vector<char> run() {
        std::vector<char> result(slots_.size());
        for (std::size_t slot = 0; slot < slots_.size(); ++slot) {
            decide(slot);
            result[slots_[slot].rank] = state_[slot] == State::selected;
        }
        return result;
    }

private:
    enum class State : char { open, selected, dropped };

    void decide(std::size_t slot) {
        if (state_[slot] != State::open) return;
        waiting_.assign(1, slot);
        while (!waiting_.empty()) {
            if (try_to_decide(waiting_.back())) waiting_.pop_back();
        }
    }

    /// Decides a circle, or puts one on top of those waiting that must be decided before.
    bool try_to_decide(std::size_t slot) {
        const Ranked& own = slots_[slot];
        const std::size_t nobody = slots_.size();
        std::size_t undecided = nobody;
        bool dropped = false;
        for (int k = 0; k <= class_of_[slot] && !dropped; ++k) {
            const SizeClass& larger = classes_[static_cast<std::size_t>(k)];
            const double farthest = rule_.distance(larger.largest(), own.circle);
            larger.visit_near(own.circle, farthest, own.rank, [&](std::size_t other) {
                if (state_[other] == State::dropped || !meets(slots_[other], own)) return true;
                if (state_[other] == State::selected) {
                    dropped = true;
                } else if (undecided == nobody) {
                    undecided = other;
                }
                return !dropped;
            });
        }
        if (!dropped && undecided != nobody) {
            waiting_.push_back(undecided);
            return false;
        }
        state_[slot] = dropped ? State::dropped : State::selected;
        return true;
    }

    [[nodiscard]] bool meets(const Ranked& larger, const Ranked& own) const {
        const double gap_y = std::abs(own.circle.y - larger.circle.y);
        const double dx = own.circle.x - larger.circle.x, dy = std::min(gap_y, period_ - gap_y);
        const double limit = rule_.distance(larger.circle, own.circle);
        return dx * dx + dy * dy < limit * limit;
    }

    double period_;
    CircleRule rule_;
    std::vector<SizeClass> classes_;
    std::vector<Ranked> slots_;
    std::vector<char> class_of_;
    std::vector<State> state_;
    std::vector<std::size_t> waiting_;
};

}  // namespace

std::vector<Circle> greedy_circles(const std::vector<Circle>& circles, double period, CircleRule rule) {
    const std::vector<char> selected = Selection(circles, period, rule).run();
    std::vector<Circle> result;
    for (std::size_t k = 0; k < circles.size(); ++k) {
        if (selected[k]) result.push_back(circles[k]);
    }
    return result;
}

}  // namespace recoat
