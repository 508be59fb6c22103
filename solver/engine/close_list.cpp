#include "solver/engine/close_list.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "solver/engine/partner.hpp"

namespace recoat {

namespace {

double wall_separation(const Wall& wall, const Row& p) {
    return wall.kind == WallKind::plane ? PlaneShape(wall).meet(p.xyz(), p.w).separation
                                        : BoxShape(wall).meet(p.xyz(), p.w).separation;
}

/// Copies history between contacts that both lists hold; both ranges are sorted by `key`.
void hand_over(const Contacts& old, std::size_t from, std::size_t from_end, Contacts& to, std::size_t at,
               std::size_t at_end, const std::vector<std::int32_t> Contacts::*key) {
    for (; at < at_end; ++at) {
        while (from < from_end && (old.*key)[from] < (to.*key)[at]) ++from;
        if (from == from_end) return;
        if ((old.*key)[from] != (to.*key)[at]) continue;
        to.slip_x[at] = old.slip_x[from];
        to.slip_y[at] = old.slip_y[from];
        to.slip_z[at] = old.slip_z[from];
        to.attraction[at] = old.attraction[from];
    }
}

/// Where each particle's pairs start in a list sorted by first.
std::vector<std::size_t> starts(const Contacts& contacts, std::size_t particles) {
    std::vector<std::size_t> begin(particles + 1, 0);
    for (std::size_t k = 0; k < contacts.pairs; ++k) ++begin[static_cast<std::size_t>(contacts.first[k]) + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    return begin;
}

}  // namespace

Contacts make_close_list(OpenMP& space, const CloseListInput& in, const Contacts& old) {
    const std::size_t n = in.position.size();
    const Period period(in.y_period);
    const auto near = [&](std::size_t i, std::int32_t j) {
        const Row &p = in.position[i], &q = in.position[static_cast<std::size_t>(j)];
        const double reach = p.w + q.w + in.range;
        return squared_norm(period.nearest(q.xyz() - p.xyz())) < reach * reach;
    };
    std::vector<std::size_t> begin(n + 1, 0);
    space.for_each(n, [&](std::size_t i) {
        std::size_t count = 0;
        for (std::size_t e = in.far.begin[i]; e < in.far.begin[i + 1]; ++e) count += near(i, in.far.second[e]);
        begin[i + 1] = count;
    });
    std::partial_sum(begin.begin(), begin.end(), begin.begin());

    Contacts made;
    made.pairs = begin[n];
    std::vector<std::int32_t> at_walls;
    made.wall_begin.push_back(made.pairs);
    for (const Wall& wall : in.walls) {
        for (std::size_t i = 0; wall.active && i < n; ++i)
            if (wall_separation(wall, in.position[i]) < in.range) at_walls.push_back(static_cast<std::int32_t>(i));
        made.wall_begin.push_back(made.pairs + at_walls.size());
    }
    made.resize(made.pairs + at_walls.size(), in.cohesive, in.relative_rolling);
    std::copy(at_walls.begin(), at_walls.end(), made.first.begin() + static_cast<std::ptrdiff_t>(made.pairs));
    for (std::size_t w = 0; w < in.walls.size(); ++w) {
        for (std::size_t k = made.wall_begin[w]; k < made.wall_begin[w + 1]; ++k)
            made.second[k] = -1 - static_cast<std::int32_t>(w);
        if (old.size() > 0)
            hand_over(old, old.wall_begin[w], old.wall_begin[w + 1], made, made.wall_begin[w], made.wall_begin[w + 1],
                      &Contacts::first);
    }
    const std::vector<std::size_t> before = starts(old, n);
    space.for_each(n, [&](std::size_t i) {
        std::size_t k = begin[i];
        for (std::size_t e = in.far.begin[i]; e < in.far.begin[i + 1]; ++e) {
            if (!near(i, in.far.second[e])) continue;
            made.first[k] = static_cast<std::int32_t>(i);
            made.second[k++] = in.far.second[e];
        }
        hand_over(old, before[i], before[i + 1], made, begin[i], begin[i + 1], &Contacts::second);
    });
    list_incidence(made, n);
    return made;
}

Contacts renamed(const Contacts& old, const std::vector<std::int32_t>& new_place) {
    const auto place = [&](std::int32_t i) { return new_place[static_cast<std::size_t>(i)]; };
    Contacts made = old;
    std::vector<std::size_t> order(old.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t k = 0; k < old.size(); ++k) {
        made.first[k] = place(old.first[k]);
        if (k < old.pairs) {
            made.second[k] = place(old.second[k]);
            if (made.first[k] > made.second[k]) std::swap(made.first[k], made.second[k]);
        }
    }
    const auto by_place = [&](std::size_t a, std::size_t b) {
        return made.first[a] != made.first[b] ? made.first[a] < made.first[b] : made.second[a] < made.second[b];
    };
    const auto at = [&](std::size_t k) { return order.begin() + static_cast<std::ptrdiff_t>(k); };
    std::sort(at(0), at(old.pairs), by_place);
    for (std::size_t w = 0; w + 1 < old.wall_begin.size(); ++w)
        std::sort(at(old.wall_begin[w]), at(old.wall_begin[w + 1]), by_place);
    const std::vector<std::int32_t> first = made.first, second = made.second;
    for (std::size_t k = 0; k < old.size(); ++k) {
        const std::size_t o = order[k];
        // Where the partners change places, so does the sign of the first's displacement relative to the second.
        const double sign = o < old.pairs && place(old.first[o]) > place(old.second[o]) ? -1 : 1;
        made.first[k] = first[o];
        made.second[k] = second[o];
        made.slip_x[k] = sign * old.slip_x[o];
        made.slip_y[k] = sign * old.slip_y[o];
        made.slip_z[k] = sign * old.slip_z[o];
        made.attraction[k] = old.attraction[o];
    }
    return made;
}

void list_incidence(Contacts& c, std::size_t particles) {
    c.incidence_begin.assign(particles + 1, 0);
    const auto count = [&](std::int32_t i) { ++c.incidence_begin[static_cast<std::size_t>(i) + 1]; };
    for (std::size_t k = 0; k < c.size(); ++k) {
        count(c.first[k]);
        if (k < c.pairs) count(c.second[k]);
    }
    std::partial_sum(c.incidence_begin.begin(), c.incidence_begin.end(), c.incidence_begin.begin());
    c.incidence.resize(c.incidence_begin[particles]);
    std::vector<std::size_t> next(c.incidence_begin.begin(), c.incidence_begin.end() - 1);
    for (std::size_t k = 0; k < c.size(); ++k) {
        const auto entry = static_cast<std::int32_t>(2 * k);
        c.incidence[next[static_cast<std::size_t>(c.first[k])]++] = entry;
        if (k < c.pairs) c.incidence[next[static_cast<std::size_t>(c.second[k])]++] = entry + 1;
    }
}

}  // namespace recoat
