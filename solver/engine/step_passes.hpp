#pragma once

#include "solver/engine/attraction_pass.hpp"
#include "solver/engine/contact_loop.hpp"
#include "solver/engine/contact_pass.hpp"
#include "solver/engine/impulse_choice.hpp"
#include "solver/engine/limits.hpp"
#include "solver/engine/particle_pass.hpp"
#include "solver/engine/snapshot.hpp"

namespace recoat {

/// Where the loops of a step find what decides about it.
struct StepMemory {
    StepControl* control;
    const WallAnchor* wall;  ///< [walls]
};

/// The loops that a step consists of, for one scene. `Sizes` knows whether all particles are alike.
template <class Sizes, bool cohesive, bool relative_rolling>
class StepPasses {
public:
    /// `smallest`: radius of the smallest particle [m].
    StepPasses(const EngineSetup& setup, const Sizes& sizes, double smallest)
        : setup_(setup),
          sizes_(sizes),
          law_(contact_law<cohesive>(setup.model)),
          impulse_(choose_impulse(setup.model, setup.time_step, sizes, smallest)),
          overlap_limit_(limits::overlap * smallest),
          speed_limit_(limits::travel_per_step * smallest / setup.time_step) {}

    [[nodiscard]] const Sizes& sizes() const { return sizes_; }
    [[nodiscard]] const ContactLaw<cohesive>& law() const { return law_; }
    [[nodiscard]] double speed_limit() const { return speed_limit_; }
    [[nodiscard]] Attraction attraction() const { return {setup_.model.minimum_separation, setup_.model.cut_off}; }

    /// Contact forces at the present positions; `ageing`: time by which the history grows [s].
    template <class Space>
    [[nodiscard]] auto contacts(SnapshotOf<Space>& s, const StepMemory& memory, double ageing) const {
        const ParticleView p = s.particles.view();
        const ContactView c = s.contacts.view();
        return over_contacts(s, memory, StepStage::contacts, [&](const auto& partner) {
            using Pass = ContactPass<std::decay_t<decltype(partner)>, cohesive, relative_rolling>;
            return Pass{partner, law_, p, c, setup_.time_step, ageing, 0, s.contacts.incidence_begin.data()};
        });
    }

    /// Attraction before the first step, as if it had been there before.
    template <class Space>
    [[nodiscard]] auto first_attraction(SnapshotOf<Space>& s, const StepMemory& memory) const {
        return over_contacts(s, memory, StepStage::contacts, [&](const auto& partner) {
            using Pass = FirstAttractionPass<std::decay_t<decltype(partner)>>;
            return Pass{partner, attraction(), s.particles.view(), s.contacts.view(), 0};
        });
    }

    template <class Space>
    [[nodiscard]] auto forces(SnapshotOf<Space>& s, const StepMemory& memory) const {
        return over_particles(s, memory, StepStage::forces, particle_pass(s));
    }

    /// Calls run(loop) for the loops of the attraction in the scheme chosen, and last(loop) for the one that moves the
    /// particles.
    template <class Space, class Run, class Last>
    void attract(SnapshotOf<Space>& s, const StepMemory& memory, const Run& run, const Last& last) const {
        std::visit(
            [&](const auto& impulse) {
                using Impulse = std::decay_t<decltype(impulse)>;
                const ImpulsePass<Sizes> motion{sizes_,
                                                s.particles.view(),
                                                incidence(s),
                                                s.contacts.impulse.data(),
                                                setup_.time_step,
                                                Impulse::half_step_positions ? 0.5 : 0.0,
                                                speed_limit_ * speed_limit_};
                run(impulses<false>(s, memory, impulse));
                if constexpr (Impulse::half_step_positions) {
                    for (int pass = 0; pass < corrections_of_impulses; ++pass) {
                        run(over_particles(s, memory, StepStage::attraction, ForeseePass<Sizes>{motion}));
                        run(impulses<true>(s, memory, impulse));
                    }
                }
                last(over_particles(s, memory, StepStage::attraction, motion));
            },
            impulse_);
    }

    [[nodiscard]] StepEnd end(const StepMemory& memory) const {
        return {memory.control, setup_.time_step, overlap_limit_, cohesive};
    }

    template <class Space>
    [[nodiscard]] ParticlePass<Sizes, cohesive, relative_rolling> particle_pass(SnapshotOf<Space>& s) const {
        const bool by_radius = setup_.model.rolling_length != RollingLength::reduced_radius;
        const double length = setup_.model.rolling_length == RollingLength::diameter ? 2 : 1;
        return {sizes_,
                law_.rolling,
                s.particles.view(),
                incidence(s),
                s.contacts.force.data(),
                s.contacts.rolling.data(),
                s.lost_rolling.data(),
                setup_.gravity,
                setup_.time_step,
                by_radius ? length : 0.0,
                by_radius ? 0.0 : 1.0,
                speed_limit_ * speed_limit_};
    }

private:
    template <bool again, class Space, class Impulse>
    [[nodiscard]] auto impulses(SnapshotOf<Space>& s, const StepMemory& memory, const Impulse& impulse) const {
        return over_contacts(s, memory, StepStage::attraction, [&](const auto& partner) {
            using Pass = AttractionPass<std::decay_t<decltype(partner)>, Impulse, again>;
            return Pass{partner, impulse, s.particles.view(), s.contacts.view(), setup_.time_step, 0};
        });
    }

    template <class Space>
    static IncidenceView incidence(SnapshotOf<Space>& s) {
        return {s.contacts.incidence_begin.data(), s.contacts.incidence.data()};
    }

    [[nodiscard]] StepGate gate(const StepMemory& memory, StepStage stage) const {
        return {memory.control, overlap_limit_, stage};
    }

    static double* peak(const StepMemory& memory, StepStage stage) {
        return memory.control->peak + static_cast<std::size_t>(stage);
    }

    template <class Space, class Make>
    [[nodiscard]] auto over_contacts(SnapshotOf<Space>& s, const StepMemory& memory, StepStage stage,
                                     const Make& make) const {
        const ContactLayout layout{s.contacts.offsets.data(), memory.control, s.walls.now().size(), memory.wall};
        const double radius_arm = setup_.model.lever_arm == LeverArm::radius ? 1 : 0;
        return contact_loop(gate(memory, stage), peak(memory, stage), sizes_, Period(setup_.y_period), radius_arm,
                            layout, setup_.time_step, s.contacts.first.capacity(), make);
    }

    template <class Space, class Pass>
    [[nodiscard]] auto over_particles(SnapshotOf<Space>& s, const StepMemory& memory, StepStage stage,
                                      const Pass& pass) const {
        return ParticleLoop<Pass>{gate(memory, stage), peak(memory, stage), pass, s.particles.size()};
    }

    EngineSetup setup_;
    Sizes sizes_;
    ContactLaw<cohesive> law_;
    ImpulseChoice impulse_;
    double overlap_limit_, speed_limit_;
};

}  // namespace recoat
