#pragma once

#include "solver/engine/engine.hpp"
#include "solver/engine/tile_work.hpp"

namespace recoat {

/// The same coefficients with numbers of another type.
template <class Real>
CoefficientsOf<Real> cast(const Coefficients& c) {
    const auto real = [](double x) { return static_cast<Real>(x); };
    return {real(c.hertz),         real(c.inverse_hertz),  real(c.normal_damping),     real(c.tangential_damping),
            real(c.inverse_mass),  real(c.attraction_gap), real(c.attraction_contact), real(c.attraction_friction),
            real(c.rolling_length)};
}

template <class Real>
ContactScaleOf<Real> cast(const ContactScale& s) {
    const auto real = [](double x) { return static_cast<Real>(x); };
    return {
        real(s.modulus),         real(s.shear_modulus),      real(s.normal_damping),      real(s.tangential_damping),
        real(s.attraction_gap),  real(s.attraction_contact), real(s.attraction_friction), real(s.rolling_factor),
        real(s.rolling_constant)};
}

/// Fills in what depends on the sizes of the particles: `radius` is that of all of them, or 0 where they differ.
template <class Variant>
void set_sizes(TileWork<Variant>& work, const EngineSetup& setup, double radius, double smallest) {
    using Real = typename Variant::Real;
    const ContactModel& model = setup.model;
    work.attraction = {static_cast<Real>(model.minimum_separation), static_cast<Real>(model.cut_off)};
    if constexpr (Variant::equal) {
        const EqualSizes sizes = equal_sizes(model, radius);
        work.sizes = {cast<Real>(sizes.pair), cast<Real>(sizes.wall), sizes.radius,         sizes.mass,
                      sizes.inertia,          sizes.inverse_mass,     sizes.inverse_inertia};
        work.impulse = cast<Real>(choose_impulse(model, setup.time_step, sizes, smallest));
    } else {
        const AnySizes sizes = any_sizes(model);
        work.sizes = {cast<Real>(sizes.pair), cast<Real>(sizes.wall), sizes.density};
        work.impulse = cast<Real>(choose_impulse(model, setup.time_step, sizes, smallest));
    }
}

}  // namespace recoat
