#pragma once

#include "solver/engine/cells.hpp"
#include "solver/engine/particles.hpp"

namespace recoat {

/// Brings y into [y_min, y_min + period); a period of 0 means none.
RECOAT_HD double folded(double y, double y_min, double period) {
    if (!(period > 0)) return y;
    const double inside = y - period * std::floor((y - y_min) / period);
    return inside < y_min + period ? inside : y_min;
}

/// Moves entries: `order` is new place -> old place, `other` is scratch.
template <class Space, class Array, class Order>
void reorder(Space& space, Array& array, Array& other, const Order& order) {
    space.copy(array, other);
    auto* to = array.data();
    const auto* from = other.data();
    const std::int32_t* old_place = order.data();
    space.for_each(array.size(), [=] RECOAT_LAMBDA(std::size_t i) { to[i] = from[old_place[i]]; });
}

/// Puts particles that are close in space close in memory.
template <class Space>
class SpatialSort {
public:
    template <class T>
    using Array = typename Space::template Array<T>;

    /// Wraps y and sorts the particles by cells of their diameter and `skin`, then by identity. Those that sleep come
    /// last: `asleep` are [N] flags that are 1 for them, or null where nobody sleeps.
    void operator()(Space& space, ParticleArrays<Space>& particles, double skin, double y_min, double y_period,
                    const std::int32_t* asleep = nullptr) {
        const std::size_t n = particles.size();
        Row* position = particles.position.data();
        space.for_each(n, [=] RECOAT_LAMBDA(std::size_t i) { position[i].y = folded(position[i].y, y_min, y_period); });
        const Extent extent = extent_of(space, position, n);
        const Cells cells = make_cells(extent, 2 * extent.largest_radius + skin, y_min, y_period);
        key_.resize(n);
        std::uint64_t* key = key_.data();
        const std::int64_t* id = particles.id.data();
        space.for_each(n, [=] RECOAT_LAMBDA(std::size_t i) {
            const std::int64_t after = asleep && asleep[i] != 0 ? cells.count() : 0;
            key[i] =
                static_cast<std::uint64_t>(after + cells.key(position[i])) << 32 | static_cast<std::uint64_t>(id[i]);
        });
        space.sorted_order(key_, static_cast<std::uint64_t>((asleep ? 2 : 1) * cells.count()) << 32, order_);
        particles.each_row([&](Array<Row>& rows) { reorder(space, rows, row_, order_); });
        reorder(space, particles.id, id_, order_);
    }

    /// Brings other rows of the particles into the same order.
    void follow(Space& space, Array<Row>& rows) { reorder(space, rows, row_, order_); }

    /// New place -> old place.
    [[nodiscard]] const Array<std::int32_t>& order() const { return order_; }

private:
    Array<std::uint64_t> key_;
    Array<std::int32_t> order_;
    Array<Row> row_;
    Array<std::int64_t> id_;
};

}  // namespace recoat
