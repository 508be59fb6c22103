#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "common/error.hpp"
#include "solver/scene/engine_factory.hpp"

namespace recoat::testing {

/// What a fake engine was asked to do, and how it behaves.
struct FakeScript {
    std::vector<std::string> log;  ///< "STEP: what"
    std::function<double(std::int64_t step)> kinetic_energy = [](std::int64_t) { return 1.0; };
    RestLimit rest;  ///< it was last asked about
    std::int64_t fault_at = -1;
    int made = 0, restored = 0;
};

/// Particles that move straight on; nothing touches. Keeps its state in full, so that restoring it can be checked.
class FakeEngine : public Engine {
public:
    FakeEngine(FakeScript& script, double time_step, ParticleTable particles, std::vector<Wall> walls)
        : script_(script), time_step_(time_step), particles_(std::move(particles)), walls_(std::move(walls)) {}

    FakeEngine(FakeScript& script, double time_step, const EngineState& state)
        : script_(script), time_step_(time_step) {
        step_ = state.integers.at("step").at(0);
        const auto& x = state.reals.at("particles/x");
        for (std::size_t i = 0; i < x.size(); i += 7) {
            particles_.position.push_back({x[i], x[i + 1], x[i + 2]});
            particles_.velocity.push_back({x[i + 3], x[i + 4], x[i + 5]});
            particles_.angular_velocity.push_back({});
            particles_.radius.push_back(x[i + 6]);
        }
        work_ = state.reals.at("work").at(0);
        const auto& places = state.reals.at("walls");
        for (const char* name : {"base", "rear", "front", "blade", "gate"}) {
            std::size_t i = 12 * walls_.size();
            Wall& wall = walls_.emplace_back();
            wall.name = name;
            for (Vec3* place : {&wall.velocity, &wall.point, &wall.lower, &wall.upper}) {
                *place = {places.at(i), places.at(i + 1), places.at(i + 2)};
                i += 3;
            }
        }
    }

    void advance(std::int64_t steps) override {
        for (; steps > 0; --steps) {
            if (step_ == script_.fault_at) throw SimulationFault("particle 3 left the domain at step 7.");
            for (std::size_t i = 0; i < particles_.size(); ++i) {
                particles_.position[i] += time_step_ * particles_.velocity[i];
            }
            for (Wall& wall : walls_) {
                work_ += 1e-15 * norm(wall.velocity);
                for (Vec3* place : {&wall.point, &wall.lower, &wall.upper}) *place += time_step_ * wall.velocity;
            }
            ++step_;
        }
    }
    std::int64_t step() const override { return step_; }
    double time() const override { return static_cast<double>(step_) * time_step_; }
    ParticleTable particles() const override { return particles_; }
    std::vector<ContactState> contacts() const override { return {}; }
    EnergyLedger ledger() const override {
        EnergyLedger ledger;
        ledger.wall_work = work_;
        ledger.dissipated_rolling = 0.75 * work_;
        ledger.gravity = 0.25 * work_;
        return ledger;
    }
    double kinetic_energy() const override { return script_.kinetic_energy(step_); }
    bool at_rest(const RestLimit& limit) const override {
        script_.rest = limit;
        return kinetic_energy() < limit.kinetic_energy;
    }
    double largest_overlap() const override { return 0.001; }
    const std::vector<Wall>& walls() const override { return walls_; }
    void set_wall_velocity(std::size_t wall, Vec3 velocity) override {
        note(walls_.at(wall).name + (velocity == Vec3{} ? " stops" : " moves"));
        walls_[wall].velocity = velocity;
    }
    void remove_wall(std::size_t wall) override {
        note(walls_.at(wall).name + " removed");
        walls_[wall].active = false;
    }
    EngineState save() const override {
        EngineState state;
        state.integers["step"] = {step_};
        for (std::size_t i = 0; i < particles_.size(); ++i) {
            const Vec3 p = particles_.position[i], v = particles_.velocity[i];
            for (double value : {p.x, p.y, p.z, v.x, v.y, v.z, particles_.radius[i]}) {
                state.reals["particles/x"].push_back(value);
            }
        }
        state.reals["work"] = {work_};
        for (const Wall& wall : walls_) {
            for (const Vec3 v : {wall.velocity, wall.point, wall.lower, wall.upper})
                state.reals["walls"].insert(state.reals["walls"].end(), {v.x, v.y, v.z});
        }
        state.reals["nothing"] = {};
        return state;
    }

private:
    void note(const std::string& what) { script_.log.push_back(std::to_string(step_) + ": " + what); }

    FakeScript& script_;
    double time_step_;
    std::int64_t step_ = 0;
    double work_ = 0;
    ParticleTable particles_;
    std::vector<Wall> walls_;
};

inline EngineFactory fake_factory(FakeScript& script) {
    return {[&script](const EngineSetup& setup, const ParticleTable& particles, std::vector<Wall> walls) {
                ++script.made;
                return std::make_unique<FakeEngine>(script, setup.time_step, particles, std::move(walls));
            },
            [&script](const EngineSetup& setup, const EngineState& state) {
                ++script.restored;
                return std::make_unique<FakeEngine>(script, setup.time_step, state);
            }};
}

}  // namespace recoat::testing
