#include "analyzer/fields/coincidence.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "analyzer/fields/sort_in_pieces.hpp"

namespace recoat {
namespace {

class Groups {
public:
    explicit Groups(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }

    std::size_t find(std::size_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::size_t a, std::size_t b) {
        a = find(a);
        b = find(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::size_t> parent_;
};

}  // namespace

std::vector<std::size_t> first_coincident(std::span<const PlanePoint> points, double period, double tolerance) {
    struct Place {
        double x;
        std::size_t index;
    };
    std::vector<Place> places(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) places[i] = {points[i].x, i};
    sort_in_pieces(places, std::mem_fn(&Place::x),
                   [](const Place& a, const Place& b) { return a.x != b.x ? a.x < b.x : a.index < b.index; });
    Groups groups(points.size());
    const auto join_if_near = [&](std::size_t a, std::size_t b, double shift) {
        if (std::abs(points[a].x - points[b].x) <= tolerance &&
            std::abs(points[b].y + shift - points[a].y) <= tolerance)
            groups.join(a, b);
    };
    // Runs of points with small steps along x; within a run near points follow each other along y.
    std::vector<std::size_t> run;
    for (std::size_t begin = 0; begin < places.size();) {
        std::size_t end = begin + 1;
        while (end < places.size() && places[end].x - places[end - 1].x <= tolerance) ++end;
        if (end - begin > 1) {
            run.clear();
            for (std::size_t k = begin; k < end; ++k) run.push_back(places[k].index);
            std::ranges::sort(run, [&](std::size_t a, std::size_t b) {
                return points[a].y != points[b].y ? points[a].y < points[b].y : a < b;
            });
            for (std::size_t k = 1; k < run.size(); ++k) join_if_near(run[k - 1], run[k], 0);
            join_if_near(run.back(), run.front(), period);
        }
        begin = end;
    }
    std::vector<std::size_t> first(points.size());
    for (std::size_t i = 0; i < first.size(); ++i) first[i] = groups.find(i);
    return first;
}

}  // namespace recoat
