#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <variant>

#include "solver/engine/attraction_pass.hpp"
#include "solver/engine/close_list.hpp"
#include "solver/engine/contact_pass.hpp"
#include "solver/engine/energy.hpp"
#include "solver/engine/engine.hpp"
#include "solver/engine/fault.hpp"
#include "solver/engine/impulse_choice.hpp"
#include "solver/engine/limits.hpp"
#include "solver/engine/moving_walls.hpp"
#include "solver/engine/particle_pass.hpp"
#include "solver/engine/partners.hpp"
#include "solver/engine/snapshot.hpp"
#include "solver/engine/spatial_sort.hpp"

namespace recoat {

/// The step, written once. `Space` runs the loops; `Sizes` knows whether all particles are alike.
///
/// Leapfrog with on-step velocities in the contact terms, then the attraction as an impulse [docs/physics.md 2.5, 4.3].
template <class Space, class Sizes, bool cohesive, bool relative_rolling>
class EngineOf final : public Engine {
public:
    EngineOf(const EngineSetup& setup, Sizes sizes, Snapshot snapshot)
        : setup_(setup),
          space_(setup.threads),
          sizes_(sizes),
          law_(contact_law<cohesive>(setup.model)),
          s_(std::move(snapshot)) {
        const double smallest = s_.particles.size() > 0 ? smallest_radius(s_.particles) : 0.5 * setup.diameter;
        impulse_ = choose_impulse(setup.model, setup.time_step, sizes, smallest);
        speed_limit_ = limits::travel_per_step * smallest / setup.time_step;
        overlap_limit_ = limits::overlap * smallest;
        if (s_.fresh)
            start();
        else
            restore_lists();
        kept_ = s_;
    }

    void advance(std::int64_t steps) override try {
        for (std::int64_t k = 0; k < steps; ++k) step_once();
    } catch (const SimulationFault&) {
        rewind(s_.step);
        throw;
    }

    [[nodiscard]] std::int64_t step() const override { return s_.step; }
    [[nodiscard]] double time() const override { return static_cast<double>(s_.step) * setup_.time_step; }
    [[nodiscard]] ParticleTable particles() const override { return table_of(s_.particles, setup_); }
    [[nodiscard]] double kinetic_energy() const override { return kinetic(s_.particles, sizes_).total(); }
    [[nodiscard]] double largest_overlap() const override { return s_.largest_overlap / setup_.diameter; }
    [[nodiscard]] const std::vector<Wall>& walls() const override { return s_.walls.now(); }
    void set_wall_velocity(std::size_t wall, Vec3 velocity) override {
        s_.walls.drive(wall, velocity, s_.step);
        kept_ = s_;
    }
    [[nodiscard]] EngineState save() const override { return s_.save(); }

    void remove_wall(std::size_t wall) override {
        settle_counters();
        // Friction springs that go with the wall are already booked as taken by friction.
        const auto held = [](const EnergyLedger& l) { return l.stored() - l.elastic_tangential; };
        const double before = held(stored());
        s_.walls.remove(wall);
        refresh_lists();
        s_.totals.removed_with_walls += before - held(stored());
        kept_ = s_;
    }

    [[nodiscard]] EnergyLedger ledger() const override {
        EnergyLedger ledger = stored();
        Totals totals = s_.totals;
        totals.add(s_.contacts, s_.lost_rolling, relative_rolling);
        ledger.dissipated_normal = totals.lost_normal;
        // What friction took includes what its springs still hold.
        ledger.dissipated_tangential = totals.lost_tangential - ledger.elastic_tangential;
        ledger.dissipated_rolling = totals.lost_rolling;
        ledger.wall_work = totals.wall_work;
        ledger.removed_with_walls = totals.removed_with_walls;
        return ledger;
    }

    [[nodiscard]] std::vector<ContactState> contacts() const override {
        Contacts now = s_.contacts;
        const_cast<EngineOf*>(this)->evaluate_contacts(now, 0);
        std::vector<ContactState> found;
        visit_meetings([&](std::size_t k, const Meeting& meeting, const Coefficients&) {
            if (meeting.separation > (cohesive ? setup_.model.cut_off : 0.0)) return;
            const Vec3 force = now.force[k].force();
            const double along = dot(force, meeting.normal);
            found.push_back({identity(s_.contacts.first[k]), identity(s_.contacts.second[k]), meeting.normal,
                             meeting.separation, -along, force - along * meeting.normal});
        });
        return ordered(std::move(found));
    }

private:
    template <class Function>
    void for_each_partner(const Contacts& c, const Function& f) const {
        visit_partners(setup_, sizes_, s_.walls.now(), c, f);
    }

    /// Calls f(contact, meeting, coefficients) for every listed contact, in order.
    template <class Function>
    void visit_meetings(const Function& f) const {
        const ParticleView p = const_cast<Particles&>(s_.particles).view();
        const Contacts& c = s_.contacts;
        for_each_partner(c, [&](const auto& partner, std::size_t from, std::size_t count) {
            for (std::size_t k = from; k < from + count; ++k)
                f(k, partner.meet(p, c.first[k], c.second[k]), partner.coefficients(p, c.first[k], c.second[k]));
        });
    }

    /// Contact forces at the present positions; returns the largest overlap [m].
    double evaluate_contacts(Contacts& c, double ageing) {
        double peak = 0;
        for_each_partner(c, [&](const auto& partner, std::size_t from, std::size_t count) {
            using Partner = std::decay_t<decltype(partner)>;
            const ContactPass<Partner, cohesive, relative_rolling> pass{
                partner, law_, s_.particles.view(), c.view(), setup_.time_step, ageing, from};
            peak = std::max(peak, space_.for_each_max(count, pass));
        });
        return peak;
    }

    [[nodiscard]] ParticlePass<Sizes, cohesive, relative_rolling> particle_pass() {
        const bool by_radius = setup_.model.rolling_length != RollingLength::reduced_radius;
        const double length = setup_.model.rolling_length == RollingLength::diameter ? 2 : 1;
        return {sizes_,
                law_.rolling,
                s_.particles.view(),
                {s_.contacts.incidence_begin.data(), s_.contacts.incidence.data()},
                s_.contacts.force.data(),
                s_.contacts.rolling.data(),
                s_.lost_rolling.data(),
                setup_.gravity,
                setup_.time_step,
                by_radius ? length : 0.0,
                by_radius ? 0.0 : 1.0,
                speed_limit_ * speed_limit_};
    }

    /// Impulses of the attraction, and the motion they complete; returns the largest squared speed.
    double apply_attraction() {
        double weight = 0;
        std::visit(
            [&](const auto& impulse) {
                using Impulse = std::decay_t<decltype(impulse)>;
                weight = Impulse::half_step_positions ? 0.5 : 0.0;
                for_each_partner(s_.contacts, [&](const auto& partner, std::size_t from, std::size_t count) {
                    using Partner = std::decay_t<decltype(partner)>;
                    space_.for_each_max(count,
                                        AttractionPass<Partner, Impulse>{partner, impulse, s_.particles.view(),
                                                                         s_.contacts.view(), setup_.time_step, from});
                });
            },
            impulse_);
        const ImpulsePass<Sizes> pass{sizes_,
                                      s_.particles.view(),
                                      {s_.contacts.incidence_begin.data(), s_.contacts.incidence.data()},
                                      s_.contacts.impulse.data(),
                                      setup_.time_step,
                                      weight,
                                      speed_limit_ * speed_limit_};
        const double square = space_.for_each_max_scalar(s_.particles.size(), pass);
        if (!std::isfinite(square)) throw_speed([&](std::size_t i) { return norm(pass.next_velocity(i)); });
        return square;
    }

    void step_once() {
        if (s_.step - kept_.step >= limits::steps_per_copy) kept_ = s_;
        if (2 * (s_.travelled + 2 * s_.last_travel) > s_.margin) refresh_lists();
        const double overlap = evaluate_contacts(s_.contacts, setup_.time_step);
        s_.largest_overlap = std::max(s_.largest_overlap, overlap);
        if (overlap > overlap_limit_) throw_overlap();
        const auto pass = particle_pass();
        double square = space_.for_each_max_scalar(s_.particles.size(), pass);
        if (!std::isfinite(square)) throw_speed([&](std::size_t i) { return pass.next_speed(i); });
        if constexpr (cohesive) square = apply_attraction();
        ++s_.step;
        s_.walls.move(s_.step, setup_.time_step);
        s_.last_travel = std::max(std::sqrt(square), s_.walls.fastest()) * setup_.time_step;
        s_.travelled += s_.last_travel;
    }

    /// Back to the moment before a step that failed half-way, by repeating the steps since the last copy.
    void rewind(std::int64_t step) {
        s_ = kept_;
        restore_lists();
        while (s_.step < step) step_once();
    }

    /// A first close list, and velocities half a step back.
    void start() {
        for (std::size_t i = 0; i < s_.particles.size(); ++i)
            s_.last_travel = std::max(s_.last_travel, setup_.time_step * norm(s_.particles.velocity[i].xyz()));
        refresh_lists();
        visit_meetings([&](std::size_t k, const Meeting& m, const Coefficients& c) {
            s_.contacts.attraction[k] = cohesive ? attraction().force(m.separation, c) : 0;
        });
        evaluate_contacts(s_.contacts, 0);
        const auto pass = particle_pass();
        for (std::size_t i = 0; i < s_.particles.size(); ++i) pass.start(i);
        s_.fresh = false;
    }

    [[nodiscard]] Attraction attraction() const { return {setup_.model.minimum_separation, setup_.model.cut_off}; }
    [[nodiscard]] double range() const { return cohesive ? setup_.model.cut_off : 0; }
    [[nodiscard]] double skin() const { return range() + limits::far_skin * setup_.diameter; }

    /// Makes the close list anew, and the far list and the order of the particles where they have gone stale.
    void refresh_lists() {
        settle_counters();
        const double speed = std::max(s_.last_travel, s_.walls.fastest() * setup_.time_step);
        s_.margin = std::clamp(2 * speed * limits::steps_per_close_list, limits::least_margin * setup_.diameter,
                               limits::most_margin * setup_.diameter);
        if (s_.far_reference.empty() ||
            range() + s_.margin + 2 * largest_displacement(s_.particles.position, s_.far_reference) > skin())
            refresh_far_list();
        s_.contacts = make_close_list(space_,
                                      {s_.particles.position, s_.walls.now(), far_, setup_.y_period,
                                       range() + s_.margin, cohesive, relative_rolling},
                                      s_.contacts);
        s_.travelled = 0;
    }

    void refresh_far_list() {
        sort_in_space(s_, setup_, skin());
        far_.build(space_, s_.particles.position, skin(), setup_.y_min, setup_.y_period);
        s_.far_reference = s_.particles.position;
    }

    void restore_lists() {
        far_.build(space_, s_.far_reference, skin(), setup_.y_min, setup_.y_period);
        s_.contacts.resize_scratch(cohesive);
        list_incidence(s_.contacts, s_.particles.size());
    }

    /// Moves what the contacts counted into the totals, in the order of the contacts.
    void settle_counters() {
        s_.totals.add(s_.contacts, s_.lost_rolling, relative_rolling);
        s_.contacts.clear_counters();
        std::fill(s_.lost_rolling.begin(), s_.lost_rolling.end(), 0.0);
    }

    /// Energies that particles and contacts hold now.
    [[nodiscard]] EnergyLedger stored() const {
        EnergyLedger ledger = particle_energies(s_.particles, sizes_, setup_.gravity);
        visit_meetings([&](std::size_t k, const Meeting& m, const Coefficients& c) {
            add_contact_energy(ledger, law_, attraction(), m.separation, s_.contacts.attraction[k], s_.contacts.slip(k),
                               c);
        });
        return ledger;
    }

    [[nodiscard]] std::int64_t identity(std::int32_t place) const {
        return place < 0 ? place : s_.particles.id[static_cast<std::size_t>(place)];
    }

    [[noreturn]] void throw_overlap() const {
        std::size_t worst = 0;
        double deepest = 0;
        visit_meetings([&](std::size_t k, const Meeting& m, const Coefficients&) {
            if (-m.separation > deepest || std::isnan(m.separation)) {
                deepest = -m.separation;
                worst = k;
            }
        });
        throw overlap_fault(s_, setup_, identity(s_.contacts.first[worst]), identity(s_.contacts.second[worst]),
                            deepest);
    }

    /// The particle that stopped the step is the one whose velocity, left as it was, would still leave the limit.
    template <class Speed>
    [[noreturn]] void throw_speed(const Speed& next_speed) const {
        for (std::size_t i = 0; i < s_.particles.size(); ++i)
            if (!(next_speed(i) < speed_limit_)) throw speed_fault(s_, setup_, s_.particles.id[i], speed_limit_);
        throw speed_fault(s_, setup_, -1, speed_limit_);
    }

    EngineSetup setup_;
    Space space_;
    Sizes sizes_;
    ContactLaw<cohesive> law_;
    ImpulseChoice impulse_;
    Snapshot s_, kept_;  ///< now, and some steps ago, with the same walls
    FarList far_;
    double speed_limit_ = 0, overlap_limit_ = 0;
};

}  // namespace recoat
