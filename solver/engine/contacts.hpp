#pragma once

#include <cstdint>
#include <type_traits>
#include <vector>

#include "solver/engine/row.hpp"

namespace recoat {

/// Forces of one contact, as the particles gather them: one cache line, added up as one vector.
///
/// force on the first [N], load = rolling length times friction load (length 1 where the particle gives it) [N m or N],
/// torque of friction on the first [N m], arm of the second over arm of the first [-].
struct ContactForce {
    double value[8] = {};

    ContactForce() = default;
    RECOAT_HD ContactForce(Vec3 force, double load, Vec3 torque, double arm_ratio)
        : value{force.x, force.y, force.z, load, torque.x, torque.y, torque.z, arm_ratio} {}

    RECOAT_HD Vec3 force() const { return {value[0], value[1], value[2]}; }
    RECOAT_HD double load() const { return value[3]; }
    RECOAT_HD Vec3 torque() const { return {value[4], value[5], value[6]}; }
    RECOAT_HD double arm_ratio() const { return value[7]; }
};

/// Contact arrays without ownership.
struct ContactView {
    const std::int32_t* first;
    const std::int32_t* second;
    double *slip_x, *slip_y, *slip_z;
    double* attraction;
    double *lost_normal, *lost_tangential, *wall_work;
    double *normal_x, *normal_y, *normal_z, *separation;
    ContactForce* force;
    Row* rolling;
    Row* impulse;
};

/// The close list: pairs [0, pairs) sorted by (first, second), then each wall's particles in `wall_begin` order.
///
/// History stays with the contact; what only one step needs is overwritten by the passes.
template <class Space>
struct ContactArrays {
    template <class T>
    using Array = typename Space::template Array<T>;

    std::size_t pairs = 0;
    std::vector<std::size_t> wall_begin;         ///< [walls + 1] where each wall's contacts start
    Array<std::int32_t> first, second;           ///< second = -1 - wall for walls
    Array<double> slip_x, slip_y, slip_z;        ///< tangential displacement of the first relative to the second [m]
    Array<double> attraction;                    ///< mean attraction of the last step [N]
    Array<double> lost_normal, lost_tangential;  ///< energy since the list was made [J]
    Array<double> wall_work;                     ///< work of the wall since then [J]

    // what every step writes anew
    Array<double> normal_x, normal_y, normal_z, separation;
    Array<ContactForce> force;
    Array<Row> rolling;  ///< torque of relative rolling on the first [N m]
    Array<Row> impulse;  ///< of the attraction on the first [N s]

    // where to find contacts: follows from first and second
    /// [N (1 + walls) + 1] pairs before those of particle i; at N (1 + w) + i, contacts before that of particle i and
    /// wall w
    Array<std::int32_t> offsets;
    Array<std::int32_t> incidence_begin;  ///< [N + 1]
    Array<std::int32_t> incidence;        ///< 2 contact + (1 when the particle is the second), ascending

    [[nodiscard]] std::size_t size() const { return first.size(); }

    void resize(std::size_t n) {
        first.resize(n);
        second.resize(n);
        for (auto* array : {&slip_x, &slip_y, &slip_z, &attraction, &lost_normal, &lost_tangential, &wall_work})
            array->resize(n);
    }

    /// Room for what the passes write anew in every step.
    void resize_scratch(bool cohesive, bool relative_rolling) {
        for (auto* array : {&normal_x, &normal_y, &normal_z, &separation}) array->resize(size());
        force.resize(size());
        rolling.resize(relative_rolling ? size() : 0);
        impulse.resize(cohesive ? size() : 0);
    }

    /// Gives back what resize_scratch() and the lists of contacts of each particle take.
    void drop_scratch() {
        // `= {}` would assign an empty list, for which a vector keeps its memory.
        const auto drop = [](auto&... arrays) { ((arrays = std::decay_t<decltype(arrays)>()), ...); };
        drop(normal_x, normal_y, normal_z, separation, force, rolling, impulse, incidence_begin, incidence);
    }

    [[nodiscard]] ContactView view() {
        return {first.data(),      second.data(),     slip_x.data(),      slip_y.data(),
                slip_z.data(),     attraction.data(), lost_normal.data(), lost_tangential.data(),
                wall_work.data(),  normal_x.data(),   normal_y.data(),    normal_z.data(),
                separation.data(), force.data(),      rolling.data(),     impulse.data()};
    }

    /// Calls f(of this, of the other) for every array that a checkpoint holds.
    template <class Other, class Function>
    void each_saved(Other& other, const Function& f) {
        f(first, other.first);
        f(second, other.second);
        f(slip_x, other.slip_x);
        f(slip_y, other.slip_y);
        f(slip_z, other.slip_z);
        f(attraction, other.attraction);
        f(lost_normal, other.lost_normal);
        f(lost_tangential, other.lost_tangential);
        f(wall_work, other.wall_work);
    }

    [[nodiscard]] Vec3 slip(std::size_t k) const { return {slip_x[k], slip_y[k], slip_z[k]}; }
};

}  // namespace recoat
