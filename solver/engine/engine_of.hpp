#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "solver/engine/energy.hpp"
#include "solver/engine/engine.hpp"
#include "solver/engine/fault.hpp"
#include "solver/engine/observation.hpp"
#include "solver/engine/pair_lists.hpp"
#include "solver/engine/scene_types.hpp"
#include "solver/engine/step_passes.hpp"
#include "solver/engine/step_plan.hpp"
#include "solver/engine/tile_stepper.hpp"
#include "solver/execution/value.hpp"

namespace recoat {

/// The step, written once. `Space` runs the loops and holds their arrays; `Sizes` knows whether all particles are
/// alike.
///
/// Leapfrog with on-step velocities in the contact terms, then the attraction as an impulse [docs/physics.md 2.5, 4.3].
template <class Space, class Sizes, bool cohesive, bool relative_rolling>
class EngineOf final : public Engine {
public:
    EngineOf(const EngineSetup& setup, const Sizes& sizes, Snapshot snapshot)
        : setup_(setup),
          space_(setup.resources),
          passes_(setup, sizes, smallest_radius(setup, snapshot.particles)),
          lists_(setup, smallest_radius(setup, snapshot.particles)) {
        if constexpr (Space::on_host)
            tiles_ = make_tile_stepper(setup, Sizes::equal ? sizes.radius_of(0.0) : 0,
                                       smallest_radius(setup, snapshot.particles));
        copy_snapshot(snapshot, s_, [&](const auto& from, auto& to) { space_.copy(from, to); });
        upload_walls();
        if (s_.fresh)
            start();
        else
            lists_.restore(space_, s_);
        keep();
    }

    void advance(std::int64_t steps) override {
        Halt halt = Halt::none;
        try {
            halt = run_until(s_.step + steps);
        } catch (const SimulationFault&) {
            rewind(s_.step);
            throw;
        }
        if (halt != Halt::deep && halt != Halt::fast) return;
        rewind(s_.step);
        // The step that failed may have begun with a new list.
        if (control().stale()) lists_.renew(space_, s_, anchors_);
        throw fault_of(snapshot(), setup_, halt);
    }

    [[nodiscard]] std::int64_t step() const override { return s_.step; }
    [[nodiscard]] double time() const override { return static_cast<double>(s_.step) * setup_.time_step; }
    [[nodiscard]] ParticleTable particles() const override { return table_of(host_particles(), setup_); }
    [[nodiscard]] double kinetic_energy() const override {
        return kinetic(space_, s_.particles, passes_.sizes()).total();
    }
    [[nodiscard]] bool at_rest(const RestLimit& limit) const override {
        const RestBounds bounds = rest_bounds(space_, s_.particles, s_.awake, passes_.sizes(), limit);
        const double most = limit.kinetic_energy;
        if (bounds.upper < most || !(bounds.lower < most)) return bounds.upper < most;
        return energy_without(host_particles(), s_.awake, passes_.sizes(), limit) < most;
    }
    [[nodiscard]] double largest_overlap() const override { return s_.largest_overlap / setup_.diameter; }
    [[nodiscard]] const std::vector<Wall>& walls() const override { return s_.walls.now(); }
    [[nodiscard]] EngineState save() const override { return saved(snapshot()); }
    [[nodiscard]] EnergyLedger ledger() const override {
        if (!ledger_) ledger_ = ledger_of(snapshot(), setup_);
        return *ledger_;
    }
    [[nodiscard]] std::vector<ContactState> contacts() const override { return contacts_of(snapshot(), setup_); }

    void set_wall_velocity(std::size_t wall, Vec3 velocity) override {
        s_.walls.drive(wall, velocity, s_.step);
        upload_walls();
        lists_.wall_driven(space_, s_, anchors_);
        changed();
        keep();
    }

    void remove_wall(std::size_t wall) override {
        // Friction springs that go with the wall are already booked as taken by friction.
        const auto held = [](const EnergyLedger& l) { return l.stored() - l.elastic_tangential; };
        const double before = held(ledger());
        const Totals booked = next_bookings(snapshot(), setup_);
        s_.walls.remove(wall);
        upload_walls();
        lists_.wall_removed(space_, s_, anchors_);
        changed();
        s_.totals.removed_with_walls += before - held(ledger());
        // What its contacts have lost up to now stays lost.
        s_.totals.add(booked, 0.5);
        s_.totals.add(next_bookings(snapshot(), setup_), -0.5);
        changed();
        keep();
    }

private:
    template <class T>
    using Array = typename Space::template Array<T>;

    /// Makes steps up to `target`; stops earlier only at a fault, which leaves the step half made.
    Halt run_until(std::int64_t target) {
        while (s_.step < target) {
            if (s_.step - kept_.step >= limits::steps_per_copy) keep();
            if (control().stale()) lists_.renew(space_, s_, anchors_);
            StepControl c = control();
            c.target = std::min({target, kept_.step + limits::steps_per_copy, lists_.next_look(s_)});
            run(c);
            if (c.halt == Halt::deep || c.halt == Halt::fast) return c.halt;
            lists_.look(space_, s_, anchors_);
        }
        return Halt::none;
    }

    /// Makes steps until something stops them; `control` then says what.
    void run(StepControl& control) {
        changed();
        if constexpr (Space::on_host)
            run_tiles(control);
        else
            run_passes(control);
        s_.walls.move(s_.step, setup_.time_step);
    }

    void run_tiles(StepControl& control) {
        const StepEnd end = passes_.end({&control, anchors_.data()});
        tiles_->begin(s_, lists_.made());
        while (control.halt == Halt::none) {
            tiles_->step(control);
            end();
        }
        tiles_->end();
        take(control);
    }

    void run_passes(StepControl& control) {
        control_.assign(space_, control);
        const StepMemory memory = this->memory();
        const StepEnd end = passes_.end(memory);
        while (control.halt == Halt::none) {
            space_.repeat(planned_steps(control), end, [&] { step_once(memory, end); });
            control = control_.read(space_);
            take(control);
        }
    }

    void take(const StepControl& control) {
        s_.step = control.step;
        s_.travelled = control.travelled;
        s_.last_travel = control.last_travel;
        s_.largest_overlap = control.largest_overlap;
    }

    void step_once(const StepMemory& memory, const StepEnd& end) {
        space_.run(passes_.contacts(s_, memory, setup_.time_step));
        if constexpr (cohesive) {
            space_.run(passes_.forces(s_, memory));
            passes_.attract(
                s_, memory, [&](const auto& loop) { space_.run(loop); },
                [&](const auto& motion) { space_.run_last(motion, end); });
        } else {
            space_.run_last(passes_.forces(s_, memory), end);
        }
    }

    /// The control of a step that begins now.
    [[nodiscard]] StepControl control() const {
        StepControl c;
        c.step = s_.step;
        c.awake = s_.awake;
        c.margin = s_.margin;
        c.travelled = s_.travelled;
        c.last_travel = s_.last_travel;
        c.largest_overlap = s_.largest_overlap;
        c.wall_speed = s_.walls.fastest();
        return c;
    }

    [[nodiscard]] StepMemory memory() { return {control_.data(), anchors_.data()}; }

    /// Keeps what a fault steps forward from, to the moment before it.
    void keep() {
        copy_snapshot(s_, kept_, [&](const auto& from, auto& to) { space_.copy(from, to); });
    }

    /// Back to the moment before a step that failed half-way, by repeating the steps since the last copy.
    void rewind(std::int64_t step) {
        copy_snapshot(kept_, s_, [&](const auto& from, auto& to) { space_.copy(from, to); });
        upload_walls();
        lists_.restore(space_, s_);
        changed();
        run_until(step);
    }

    /// A first close list, and velocities half a step back.
    void start() {
        const std::size_t n = s_.particles.size();
        s_.last_travel = setup_.time_step * largest_norm(space_, s_.particles.velocity.data(), n);
        space_.fill(s_.contacts.offsets, n * (1 + s_.walls.now().size()) + 1, std::int32_t{0});
        space_.fill(s_.dormant.offsets, 1, std::int32_t{0});
        lists_.refresh(space_, s_, anchors_);
        if constexpr (Space::on_host) complete_list(space_, s_.contacts, setup_.model, n, n);
        control_.assign(space_, control());
        if constexpr (cohesive) space_.run(passes_.first_attraction(s_, memory()));
        space_.run(passes_.contacts(s_, memory(), 0));
        start_leapfrog(space_, passes_.particle_pass(s_), n);
        if constexpr (Space::on_host) s_.contacts.drop_scratch();
        s_.fresh = false;
        s_.totals.add(next_bookings(snapshot(), setup_), -0.5);
        changed();
    }

    void upload_walls() { space_.copy(s_.walls.anchors(), anchors_); }

    /// Forgets what the host has seen.
    void changed() {
        seen_ = Seen::nothing;
        ledger_.reset();
    }

    /// What the host sees.
    [[nodiscard]] const Snapshot& snapshot() const {
        if constexpr (Space::on_host) {
            return s_;
        } else {
            if (seen_ != Seen::all)
                copy_snapshot(s_, host_, [&](const auto& from, auto& to) { space_.copy(from, to); });
            seen_ = Seen::all;
            return host_;
        }
    }
    [[nodiscard]] const Particles& host_particles() const {
        if constexpr (Space::on_host) {
            return s_.particles;
        } else {
            if (seen_ == Seen::nothing)
                s_.particles.each_saved(host_.particles, [&](const auto& from, auto& to) { space_.copy(from, to); });
            if (seen_ == Seen::nothing) seen_ = Seen::particles;
            return host_.particles;
        }
    }

    enum class Seen { nothing, particles, all };

    EngineSetup setup_;
    mutable Space space_;
    StepPasses<Sizes, cohesive, relative_rolling> passes_;
    PairLists<Space> lists_;
    mutable SnapshotOf<Space> s_;  ///< now
    SnapshotOf<Space> kept_;       ///< some steps ago, with the same walls
    Array<WallAnchor> anchors_;
    Value<Space, StepControl> control_;
    std::unique_ptr<TileStepper> tiles_;  ///< a processor's step
    mutable Snapshot host_;               ///< the copy that the host has of a device's snapshot
    mutable Seen seen_ = Seen::nothing;
    mutable std::optional<EnergyLedger> ledger_;  ///< of now, once it has been asked for
};

/// An engine of the types that the scene needs.
template <class Space>
std::unique_ptr<Engine> build_engine(const EngineSetup& setup, Snapshot snapshot) {
    return with_scene_types(
        setup, snapshot.particles, [&](const auto& sizes, auto cohesive, auto relative) -> std::unique_ptr<Engine> {
            using Made =
                EngineOf<Space, std::decay_t<decltype(sizes)>, decltype(cohesive)::value, decltype(relative)::value>;
            return std::make_unique<Made>(setup, sizes, std::move(snapshot));
        });
}

}  // namespace recoat
