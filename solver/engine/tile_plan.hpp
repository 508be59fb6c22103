#pragma once

#include <algorithm>
#include <vector>

#include "solver/engine/snapshot.hpp"
#include "solver/engine/tile_work.hpp"

namespace recoat {

/// A part of the particles that one thread works on at a time.
struct TilePart {
    TileRange particles;
    std::size_t beyond = 0;         ///< its pairs reach particles up to here
    std::size_t first_before = 0;   ///< first part whose pairs reach into this one
    std::vector<double> sums;       ///< of the particles from particles.end to `beyond`
    std::vector<std::size_t> near;  ///< [1 + walls] near contacts found in this step

    [[nodiscard]] bool any_near() const {
        return std::any_of(near.begin(), near.end(), [](std::size_t count) { return count > 0; });
    }
};

/// How the awake particles of a snapshot are dealt to parts and tiles: by their number alone, so that sums are the same
/// for any number of threads.
class TilePlan {
public:
    static constexpr std::size_t tile = 128;                ///< particles
    static constexpr std::size_t particles_of_part = 1024;  ///< at least, where there is more than one part
    static constexpr std::size_t most_parts = 64;

    void make(const Snapshot& s, std::size_t numbers_of_sum) {
        const std::size_t n = s.awake, walls = s.walls.now().size();
        std::size_t count = 1;
        while (count < most_parts && n >= 2 * count * particles_of_part) count *= 2;
        parts_.resize(count);
        for (std::size_t p = 0; p < count; ++p) {
            TilePart& part = parts_[p];
            part.particles = {p * n / count, (p + 1) * n / count};
            part.beyond = part.particles.end;
            for (auto k = at(s, part.particles.begin); k < at(s, part.particles.end); ++k)
                part.beyond = std::max(part.beyond, static_cast<std::size_t>(s.contacts.second[k]) + 1);
            part.sums.assign(numbers_of_sum * (part.beyond - part.particles.end), 0.0);
            part.near.assign(1 + walls, 0);
            part.first_before = p;
        }
        for (std::size_t p = count; p-- > 0;)
            for (std::size_t q = p + 1; q < count && parts_[p].beyond > parts_[q].particles.begin; ++q)
                parts_[q].first_before = p;
    }

    [[nodiscard]] std::vector<TilePart>& parts() { return parts_; }

private:
    /// Pairs before those of particle i.
    static std::size_t at(const Snapshot& s, std::size_t i) { return static_cast<std::size_t>(s.contacts.offsets[i]); }

    std::vector<TilePart> parts_;
};

}  // namespace recoat
