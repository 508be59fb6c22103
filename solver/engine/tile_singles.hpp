#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "solver/engine/snapshot.hpp"

namespace recoat {

/// What contacts see of the particles, and their history, in single precision while steps are made.
struct TileSingles {
    std::vector<float> motion;                  ///< as TileWork::motion
    std::array<std::vector<float>, 4> history;  ///< slip and attraction

    void take_motion(const Particles& p) {
        motion.resize(8 * p.size());
        for (std::size_t i = 0; i < p.size(); ++i) {
            const Row &v = p.contact_velocity[i], &w = p.contact_spin[i];
            const double both[8] = {v.x, v.y, v.z, v.w, w.x, w.y, w.z, w.w};
            for (std::size_t c = 0; c < 8; ++c) motion[8 * i + c] = static_cast<float>(both[c]);
        }
    }

    void take_history(Contacts& c) {
        for (std::size_t a = 0; a < 4; ++a) {
            const std::vector<double>& from = *doubles(c)[a];
            history[a].assign(from.begin(), from.end());
        }
    }

    /// Writes into the snapshot what steps have changed.
    void give_back(Snapshot& s) const {
        for (std::size_t i = 0; i < s.awake; ++i) {
            const float* v = motion.data() + 8 * i;
            s.particles.contact_velocity[i] = {v[0], v[1], v[2], v[3]};
        }
        for (std::size_t a = 0; a < 4; ++a)
            std::copy(history[a].begin(), history[a].end(), doubles(s.contacts)[a]->begin());
    }

private:
    static std::array<std::vector<double>*, 4> doubles(Contacts& c) {
        return {&c.slip_x, &c.slip_y, &c.slip_z, &c.attraction};
    }
};

}  // namespace recoat
