#pragma once

#include "solver/contact/law.hpp"
#include "solver/engine/tile_work.hpp"

namespace recoat {

/// A pack of contacts on its way through the parts of the law. Its fields are single packs, since g++ moves a struct of
/// packs by halves of registers, which the next part cannot load again without a stall; they hold nothing until
/// written.
template <class T>
struct TileStage {
    T normal[3], sliding_velocity[3], slip[3], pull[3];
    T separation, first_arm, second_arm, first_radius, second_radius;
    T closing_rate;
    T velocity_change;  ///< bound of what both velocities changed by in the last step [m/s]
    T repulsion, limit;
    T load, load_overlap, load_quarter, load_inverse;  ///< FrictionLoad

    static RECOAT_HD void set(T* to, const Vec3Of<T>& v) {
        to[0] = v.x;
        to[1] = v.y;
        to[2] = v.z;
    }
    static RECOAT_HD Vec3Of<T> vector(const T* from) { return {from[0], from[1], from[2]}; }

    RECOAT_HD void set_load(const FrictionLoad<T>& value) {
        load = value.force;
        load_overlap = value.overlap;
        load_quarter = value.quarter;
        load_inverse = value.inverse_overlap;
    }
    RECOAT_HD FrictionLoad<T> friction_load() const { return {load, load_overlap, load_quarter, load_inverse}; }
};

}  // namespace recoat
