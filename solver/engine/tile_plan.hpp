#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "solver/engine/snapshot.hpp"
#include "solver/engine/tile_work.hpp"

namespace recoat {

/// A part of the particles that one thread works on at a time.
struct TilePart {
    TileRange particles;
    std::vector<std::int32_t> reached;  ///< particles of later parts that its pairs reach and that are awake, rising
    std::size_t first_before = 0;       ///< first part whose pairs reach into this one
    std::span<double> sums;             ///< of those reached, then of all sleepers together
    std::vector<std::size_t> near;      ///< [1 + walls] near contacts found in this step
    std::size_t near_particles = 0;     ///< found in this step

    [[nodiscard]] bool any_near() const {
        return std::any_of(near.begin(), near.end(), [](std::size_t count) { return count > 0; });
    }
    /// Places in its own array of sums.
    [[nodiscard]] std::size_t places() const { return reached.size() + 1; }
};

/// How the awake particles of a snapshot are dealt to parts and tiles: by their number alone, so that sums are the same
/// for any number of threads. A part adds up its contacts for its own particles in their places, for those of later
/// parts in an array of its own, so that no two threads ever add to the same place. Nobody asks for the sums of
/// sleepers: they come together in one place.
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
            find_reached(s, part);
            part.near.assign(1 + walls, 0);
            part.first_before = p;
        }
        for (std::size_t p = count; p-- > 0;)
            for (std::size_t q = p + 1; q < count && reaches(parts_[p], parts_[q]); ++q) parts_[q].first_before = p;
        place_sums(s, numbers_of_sum);
    }

    [[nodiscard]] std::vector<TilePart>& parts() { return parts_; }
    /// Of the awake particles, then of the parts; all 0 when the plan is made.
    [[nodiscard]] std::vector<double>& sums() { return sums_; }
    /// [pairs] where the second of each pair is added up.
    [[nodiscard]] const std::vector<std::int32_t>& second_sums() const { return second_sums_; }

private:
    void find_reached(const Snapshot& s, TilePart& part) {
        part.reached.clear();
        place_of_.resize(std::max(place_of_.size(), s.awake), nowhere);
        for (auto k = at(s, part.particles.begin); k < at(s, part.particles.end); ++k) {
            const std::size_t j = second(s, k);
            if (j < part.particles.end || j >= s.awake || place_of_[j] != nowhere) continue;
            place_of_[j] = 0;
            part.reached.push_back(static_cast<std::int32_t>(j));
        }
        std::sort(part.reached.begin(), part.reached.end());
        for (const std::int32_t j : part.reached) place_of_[static_cast<std::size_t>(j)] = nowhere;
    }

    /// Whether the pairs of a part reach into a later one or beyond it.
    static bool reaches(const TilePart& part, const TilePart& later) {
        return !part.reached.empty() && static_cast<std::size_t>(part.reached.back()) >= later.particles.begin;
    }

    void place_sums(const Snapshot& s, std::size_t numbers) {
        const std::size_t n = s.awake;
        std::size_t places = n;
        for (const TilePart& part : parts_) places += part.places();
        sums_.assign(numbers * places, 0.0);
        second_sums_.resize(at(s, n));
        std::size_t own = n;
        for (TilePart& part : parts_) {
            part.sums = std::span(sums_).subspan(numbers * own, numbers * part.places());
            const std::size_t sleepers = own + part.reached.size();
            for (std::size_t r = 0; r < part.reached.size(); ++r)
                place_of_[static_cast<std::size_t>(part.reached[r])] = static_cast<std::int32_t>(own + r);
            for (auto k = at(s, part.particles.begin); k < at(s, part.particles.end); ++k) {
                const std::size_t j = second(s, k);
                if (j < part.particles.end)
                    second_sums_[k] = static_cast<std::int32_t>(j);
                else
                    second_sums_[k] = j < n ? place_of_[j] : static_cast<std::int32_t>(sleepers);
            }
            for (const std::int32_t j : part.reached) place_of_[static_cast<std::size_t>(j)] = nowhere;
            own += part.places();
        }
    }

    /// Pairs before those of particle i.
    static std::size_t at(const Snapshot& s, std::size_t i) { return static_cast<std::size_t>(s.contacts.offsets[i]); }
    static std::size_t second(const Snapshot& s, std::size_t k) {
        return static_cast<std::size_t>(s.contacts.second[k]);
    }

    std::vector<TilePart> parts_;
    std::vector<double> sums_;
    std::vector<std::int32_t> second_sums_;
    static constexpr std::int32_t nowhere = -1;
    std::vector<std::int32_t> place_of_;  ///< of particles that the part at hand reaches
};

}  // namespace recoat
