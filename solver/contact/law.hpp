#pragma once

#include "solver/contact/attraction.hpp"
#include "solver/contact/hertz.hpp"
#include "solver/contact/mindlin.hpp"
#include "solver/contact/rolling.hpp"

namespace recoat {

/// What one contact does to its first partner, and what that costs.
template <class T>
struct ContactResultOf {
    Vec3Of<T> force;       ///< repulsion and friction on the first partner [N]
    Vec3Of<T> tangential;  ///< friction alone [N]
    T friction_load;       ///< F^M: normal force that friction and rolling see [N]
    T normal_power;        ///< dissipated by the normal dashpot [W]
    T tangential_power;    ///< taken by friction from the motion [W]
};

using ContactResult = ContactResultOf<double>;

/// What friction and rolling see of the normal force.
template <class T>
struct FrictionLoad {
    T force;            ///< F^M [N]
    T overlap;          ///< Hertz-equivalent overlap of F^M [m]
    T quarter;          ///< its fourth root
    T inverse_overlap;  ///< [1/m]; anything where the overlap is 0
};

/// The contact law without the attraction itself: Hertz, Mindlin-Deresiewicz, and the force that friction sees under
/// stiffness scaling [paper eq. 4, 5, 8; docs/physics.md sections 1 and 2.2]. `Real` is the type of its numbers; it is
/// evaluated for a number or a pack of numbers `T` at a time.
template <bool cohesive, class Real = double>
struct ContactLaw {
    HertzOf<Real> hertz;
    MindlinOf<Real> mindlin;
    RollingOf<Real> rolling;
    Real frictional_range;  ///< a pair keeps its tangential displacement up to this separation [m]: s_min, or 0

    /// `attraction`: mean attraction that the pair felt in the previous step [N]. `displacement` is that of half a step
    /// before on entry and of half a step after on return, so that the sliding velocity of this instant counts on both
    /// sides: the sum is the trapezoidal rule, and a contact that began somewhere in the last step has slid for half.
    ///
    /// It is done in parts, each a short chain of roots, so that a processor's loop over each of them in turn has
    /// several contacts under way at a time.
    template <class T, class C>
    RECOAT_HD ContactResultOf<T> operator()(const KinematicsOf<T>& k, const C& c, T attraction, T time_step,
                                            Vec3Of<T>& displacement) const {
        const Push<T> push = this->push(k.separation, k.closing_rate, attraction, c);
        displacement = slid(displacement, k.normal, k.sliding_velocity, k.separation, time_step);
        const auto pull = this->pull(displacement, push.load, k.sliding_velocity, c);
        const Vec3Of<T> tangential = mindlin.borne(pull.sum, pull.limit);
        displacement += slid_after(k.sliding_velocity, k.separation, time_step);
        return {force(tangential, push.repulsion, k.normal), tangential, push.load.force, push.power,
                friction_power(tangential, k.sliding_velocity)};
    }

    /// Along the normal.
    template <class T>
    struct Push {
        T repulsion;           ///< elastic and viscous [N]
        T power;               ///< dissipated [W]
        FrictionLoad<T> load;  ///< what friction sees of it
    };

    template <class T, class C>
    RECOAT_HD Push<T> push(T separation, T closing_rate, T attraction, const C& c) const {
        const T overlap = larger(-separation, T(0));
        const T inverse_quarter = inverse_fourth_root(overlap);
        const T inverse = inverse_quarter * inverse_quarter;
        const T root = overlap * inverse;
        const T quarter = root * inverse_quarter;
        const T elastic = hertz.elastic(overlap, root, c);
        const T viscous = hertz.viscous(elastic, quarter, closing_rate, c);
        return {
            elastic + viscous, -(viscous * closing_rate),
            friction_load(FrictionLoad<T>{elastic, overlap, quarter, inverse * inverse}, attraction, separation, c)};
    }

    /// The displacement at this instant.
    template <class T>
    RECOAT_HD Vec3Of<T> slid(Vec3Of<T> displacement, Vec3Of<T> normal, Vec3Of<T> sliding_velocity, T separation,
                             T time_step) const {
        return kept(separation) * mindlin.advance(displacement, normal, sliding_velocity, T(0.5) * time_step);
    }
    /// What it gains in the rest of the step.
    template <class T>
    RECOAT_HD Vec3Of<T> slid_after(Vec3Of<T> sliding_velocity, T separation, T time_step) const {
        return (kept(separation) * (T(0.5) * time_step)) * sliding_velocity;
    }

    template <class T, class C>
    RECOAT_HD auto pull(Vec3Of<T>& displacement, const FrictionLoad<T>& load, Vec3Of<T> sliding_velocity,
                        const C& c) const {
        return mindlin.pull(displacement, load.force, load.overlap, load.inverse_overlap,
                            T(c.tangential_damping * load.quarter), sliding_velocity);
    }

    /// Repulsion and friction on the first partner [N].
    template <class T>
    RECOAT_HD Vec3Of<T> force(Vec3Of<T> tangential, T repulsion, Vec3Of<T> normal) const {
        return tangential - repulsion * normal;
    }
    /// Taken by friction from the motion [W].
    template <class T>
    RECOAT_HD T friction_power(Vec3Of<T> tangential, Vec3Of<T> sliding_velocity) const {
        return -dot(tangential, sliding_velocity);
    }

    /// 1 while a pair keeps its displacement, else 0.
    template <class T>
    RECOAT_HD T kept(T separation) const {
        return select(separation <= T(frictional_range), T(1), T(0));
    }

    /// F^M = max(0, F_cn^R - F_v + F_v^O), and the overlap at which Hertz gives it [docs/physics.md 2.2 (a), (c)];
    /// `elastic`: the repulsion and its overlap.
    template <class T, class C>
    RECOAT_HD FrictionLoad<T> friction_load(const FrictionLoad<T>& elastic, T attraction, T separation,
                                            const C& c) const {
        if constexpr (cohesive) {
            const T sum = elastic.force - attraction + c.attraction_friction;
            const T force = select(separation <= T(frictional_range), larger(sum, T(0)), T(0));
            const T share = force * c.inverse_hertz;
            const T sixth = inverse_sixth_root(share);
            const T square = sixth * sixth;
            return {force, share * square, share * (square * square * sixth), square * square};
        } else {
            return elastic;
        }
    }
};

template <bool cohesive>
ContactLaw<cohesive> contact_law(const ContactModel& model) {
    const double nu = model.poisson_ratio;
    return {Hertz{model.clip_normal ? 1.0 : 0.0},
            Mindlin{model.sliding_friction, model.sliding_friction * (2 - nu) / (2 - 2 * nu),
                    model.cap_dashpot ? 1.0 : 0.0},
            Rolling{model.rolling_friction}, cohesive ? model.minimum_separation : 0.0};
}

/// The same law with numbers of another type.
template <class Real, bool cohesive>
ContactLaw<cohesive, Real> law_of(const ContactLaw<cohesive>& law) {
    const auto real = [](double x) { return static_cast<Real>(x); };
    return {{real(law.hertz.clip)},
            {real(law.mindlin.friction), real(law.mindlin.slip_per_overlap), real(law.mindlin.cap)},
            {real(law.rolling.friction)},
            real(law.frictional_range)};
}

}  // namespace recoat
