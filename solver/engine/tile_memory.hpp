#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "solver/engine/snapshot.hpp"
#include "solver/engine/tile_work.hpp"

namespace recoat {

/// An array that is written before it is read: what nobody writes to takes no memory.
template <class Number>
class Sheet {
public:
    /// For `size` numbers, whatever they are.
    Number* room(std::size_t size) {
        if (size > size_) {
            numbers_ = std::make_unique_for_overwrite<Number[]>(size);
            size_ = size;
        }
        return numbers_.get();
    }

private:
    std::unique_ptr<Number[]> numbers_;
    std::size_t size_ = 0;
};

/// Lends the arrays of a snapshot to the loops of a step, and those that they need beside them. What costs more than
/// the awake particles is done only where somebody has fallen asleep.
template <class Variant>
class TileMemory {
public:
    using Real = typename Variant::Real;

    /// `s` must stay where it is while the loops run.
    void lend(Snapshot& s, TileWork<Variant>& work) {
        lend_particles(s, work);
        lend_history(s.contacts, work);
        if constexpr (Variant::cohesive) {
            const std::size_t n = s.contacts.size();
            work.near_particles = near_particle_.room(s.awake);
            work.near = {near_contact_.room(n), near_[0].room(n), near_[1].room(n), near_[2].room(n), near_[3].room(n)};
        }
        if constexpr (Variant::relative_rolling) count_contacts(s, work);
        moved_ = s.awake;
    }

    /// Brings what has its own place meanwhile back into the snapshot.
    void give_back(Snapshot& s) const {
        if constexpr (Variant::single) {
            for (std::size_t i = 0; i < s.awake; ++i) {
                const float* v = motion_.data() + 8 * i;
                s.particles.contact_velocity[i] = {v[0], v[1], v[2], v[3]};
            }
            for (std::size_t a = 0; a < 4; ++a)
                std::copy(single_[a].begin(), single_[a].end(), history(s.contacts)[a]->begin());
        }
    }

private:
    void lend_particles(Snapshot& s, TileWork<Variant>& work) {
        Particles& p = s.particles;
        const auto rows = [](std::vector<Row>& array) { return reinterpret_cast<double*>(array.data()); };
        work.position = rows(p.position);
        work.velocity = rows(p.velocity);
        work.spin = rows(p.spin);
        work.acceleration = rows(p.acceleration);
        work.contact_velocity = rows(p.contact_velocity);
        work.contact_spin = rows(p.contact_spin);
        work.lost_rolling = s.lost_rolling.data();
        if constexpr (Variant::single) {
            motion_.resize(8 * p.size());
            clear_sleepers(motion_, 8, s.awake);
            for (std::size_t i = 0; i < s.awake; ++i) {
                const Row &v = p.contact_velocity[i], &w = p.contact_spin[i];
                const double both[8] = {v.x, v.y, v.z, v.w, w.x, w.y, w.z, w.w};
                for (std::size_t c = 0; c < 8; ++c) motion_[8 * i + c] = static_cast<float>(both[c]);
            }
            work.motion = motion_.data();
        }
    }

    void lend_history(Contacts& c, TileWork<Variant>& work) {
        work.first = c.first.data();
        work.second = c.second.data();
        work.lost_normal = c.lost_normal.data();
        work.lost_tangential = c.lost_tangential.data();
        work.wall_work = c.wall_work.data();
        if constexpr (Variant::single) {
            for (std::size_t a = 0; a < 4; ++a) {
                const std::vector<double>& from = *history(c)[a];
                single_[a].assign(from.begin(), from.end());
            }
            work.slip_x = single_[0].data();
            work.slip_y = single_[1].data();
            work.slip_z = single_[2].data();
            work.last_attraction = single_[3].data();
        } else {
            work.slip_x = c.slip_x.data();
            work.slip_y = c.slip_y.data();
            work.slip_z = c.slip_z.data();
            work.last_attraction = c.attraction.data();
        }
    }

    /// Those of the awake; sleepers count for none, as on a device.
    void count_contacts(const Snapshot& s, TileWork<Variant>& work) {
        count_.resize(s.particles.size());
        clear_sleepers(count_, 1, s.awake);
        std::fill_n(count_.begin(), s.awake, 0);
        const auto count = [&](std::int32_t i) {
            if (i >= 0 && static_cast<std::size_t>(i) < s.awake) ++count_[static_cast<std::size_t>(i)];
        };
        for (std::size_t k = 0; k < s.contacts.size(); ++k) {
            count(s.contacts.first[k]);
            count(s.contacts.second[k]);
        }
        work.contact_count = count_.data();
    }

    /// Sleepers neither move nor turn: what those that have just fallen asleep left behind goes.
    template <class Number>
    void clear_sleepers(std::vector<Number>& rows, std::size_t width, std::size_t awake) const {
        for (std::size_t k = width * awake; k < width * moved_; ++k) rows[k] = 0;
    }

    static std::array<std::vector<double>*, 4> history(Contacts& c) {
        return {&c.slip_x, &c.slip_y, &c.slip_z, &c.attraction};
    }

    std::size_t moved_ = 0;  ///< particles that were awake the last time
    std::vector<float> motion_;
    std::array<std::vector<float>, 4> single_;  ///< slip and attraction
    std::vector<std::int32_t> count_;
    Sheet<std::int32_t> near_contact_, near_particle_;
    std::array<Sheet<Real>, 4> near_;
};

}  // namespace recoat
