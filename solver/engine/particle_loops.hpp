#pragma once

#include <cmath>
#include <limits>

#include "solver/engine/fault.hpp"
#include "solver/engine/row.hpp"

namespace recoat {

// Loops over particles that are run now and then. They stand by themselves because a device compiler takes loop bodies
// only from functions that everybody may call.

/// Largest length of a row [as the rows]; infinite when one is not a number.
template <class Space>
double largest_norm(Space& space, const Row* rows, std::size_t n) {
    const double none = space.maximum(n, [=] RECOAT_LAMBDA(std::size_t i) {
        const double square = squared_norm(rows[i].xyz());
        return square >= 0 ? square : std::numeric_limits<double>::infinity();
    });
    return none > 0 ? std::sqrt(none) : 0;
}

template <class Space>
bool all_inside(Space& space, const Row* position, std::size_t n, const DomainCheck& domain) {
    return !(space.maximum(
                 n, [=] RECOAT_LAMBDA(std::size_t i) { return domain.inside(position[i].xyz()) ? 0.0 : 1.0; }) > 0);
}

template <class Space>
void copy_rows(Space& space, const Row* from, Row* to, std::size_t n) {
    space.for_each(n, [=] RECOAT_LAMBDA(std::size_t i) { to[i] = from[i]; });
}

/// Takes velocities half a step back, to those of a leapfrog that was under way.
template <class Space, class Pass>
void start_leapfrog(Space& space, const Pass& pass, std::size_t n) {
    space.for_each(n, [=] RECOAT_LAMBDA(std::size_t i) { pass.start(i); });
}

}  // namespace recoat
