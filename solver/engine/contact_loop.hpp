#pragma once

#include "solver/engine/partner.hpp"
#include "solver/engine/step_control.hpp"

namespace recoat {

/// Where a loop over contacts finds them.
struct ContactLayout {
    const std::int32_t* offsets;  ///< as ContactArrays::offsets
    const StepControl* control;   ///< tells how many particles are awake: only they have contacts here
    std::size_t walls;
    const WallAnchor* wall;  ///< [walls]

    RECOAT_HD std::size_t wall_begin(std::size_t w) const {
        return static_cast<std::size_t>(offsets[control->awake * (1 + w)]);
    }
    RECOAT_HD std::size_t size() const { return wall_begin(walls); }
};

/// A pass over every contact, each with the partner it has: particle, plane or box.
template <class Pairs, class Planes, class Boxes>
struct ContactLoop {
    static constexpr bool vector = true, measures = Pairs::measures;
    StepGate gate;
    double* peak;
    Pairs pairs;
    Planes planes;
    Boxes boxes;
    ContactLayout layout;
    double time_step;
    std::size_t capacity;  ///< contacts that the arrays have room for

    RECOAT_HD bool open() const { return gate.open(); }
    RECOAT_HD std::size_t size() const { return layout.size(); }

    /// One contact, whatever its partner is.
    RECOAT_HD double operator()(std::size_t k) const {
        if (k < layout.wall_begin(0)) return pairs(k);
        std::size_t w = 0;
        while (k >= layout.wall_begin(w + 1)) ++w;
        return layout.wall[w].kind == WallKind::plane ? at_wall(planes, w)(k) : at_wall(boxes, w)(k);
    }

    /// Calls f(pass, number of contacts) for the pairs and for every wall; passes count from 0.
    template <class Function>
    void segments(const Function& f) const {
        f(pairs, layout.wall_begin(0));
        for (std::size_t w = 0; w < layout.walls; ++w) {
            const std::size_t from = layout.wall_begin(w), count = layout.wall_begin(w + 1) - from;
            if (layout.wall[w].kind == WallKind::plane)
                f(beginning(at_wall(planes, w), from), count);
            else
                f(beginning(at_wall(boxes, w), from), count);
        }
    }

private:
    template <class Pass>
    RECOAT_HD Pass at_wall(Pass pass, std::size_t w) const {
        pass.partner = pass.partner.at(layout.wall[w], gate.control->step, time_step);
        return pass;
    }
    template <class Pass>
    static Pass beginning(Pass pass, std::size_t from) {
        pass.offset = from;
        return pass;
    }
};

/// `make(partner)` gives the pass for a partner.
template <class Sizes, class Make>
auto contact_loop(const StepGate& gate, double* peak, const Sizes& sizes, Period period, double radius_arm,
                  const ContactLayout& layout, double time_step, std::size_t capacity, const Make& make) {
    using Plane = WallPartner<Sizes, PlaneShape>;
    using Box = WallPartner<Sizes, BoxShape>;
    const WallAnchor nowhere;
    const auto pairs = make(ParticlePartner<Sizes>{sizes, period, radius_arm});
    const auto planes = make(Plane{sizes, PlaneShape(nowhere, {}), {}, radius_arm});
    const auto boxes = make(Box{sizes, BoxShape(nowhere, {}), {}, radius_arm});
    return ContactLoop<std::decay_t<decltype(pairs)>, std::decay_t<decltype(planes)>, std::decay_t<decltype(boxes)>>{
        gate, peak, pairs, planes, boxes, layout, time_step, capacity};
}

/// A pass over every particle that is awake.
template <class Pass>
struct ParticleLoop {
    static constexpr bool vector = false, measures = true;
    StepGate gate;
    double* peak;
    Pass pass;
    std::size_t capacity;  ///< number of particles

    RECOAT_HD bool open() const { return gate.open(); }
    RECOAT_HD std::size_t size() const { return gate.control->awake; }
    RECOAT_HD double operator()(std::size_t i) const { return pass(i); }

    template <class Function>
    void segments(const Function& f) const {
        f(pass, size());
    }
};

}  // namespace recoat
