#include "solver/engine/tile_stepper.hpp"

#include <algorithm>
#include <limits>

#include <omp.h>

#include "solver/engine/limits.hpp"
#include "solver/engine/tile_dispatch.hpp"
#include "solver/engine/tile_memory.hpp"
#include "solver/engine/tile_plan.hpp"
#include "solver/engine/tile_sizes.hpp"
#include "solver/execution/flush_denormals.hpp"

namespace recoat {

namespace {

template <class Variant>
class Stepper final : public TileStepper {
public:
    using Real = typename Variant::Real;
    static constexpr int numbers = SumLayout<Variant>::size;

    Stepper(const EngineSetup& setup, double radius, double smallest)
        : setup_(setup),
          kernels_(kernels_of<Variant>(setup.resources.instructions)),
          threads_(std::max(1, setup.resources.threads)),
          fastest_(limits::travel_per_step * smallest / setup.time_step) {
        const bool by_radius = setup.model.rolling_length != RollingLength::reduced_radius;
        const double length = setup.model.rolling_length == RollingLength::diameter ? 2 : 1;
        set_sizes(work_, setup, radius, smallest);
        work_.law = law_of<Real>(contact_law<Variant::cohesive>(setup.model));
        work_.gravity = setup.gravity;
        work_.y_period = setup.y_period;
        work_.inverse_period = setup.y_period > 0 ? 1 / setup.y_period : 0;
        work_.time_step = setup.time_step;
        work_.radius_arm = setup.model.lever_arm == LeverArm::radius;
        work_.own_rolling_length = by_radius ? length : 0;
        work_.own_rolling_constant = by_radius ? 0 : 1;
        corrections_ = corrections_of(work_.impulse);
    }

    void begin(Snapshot& s, std::int64_t lists) override {
        snapshot_ = &s;
        walls_ = s.walls.now();
        anchors_ = s.walls.anchors();
        if (lists == lists_) return;
        lists_ = lists;
        plan_.make(s, numbers);
        tallies_.resize(plan_.parts().size());
        work_.sums = plan_.sums().data();
        work_.second_sums = plan_.second_sums().data();
        memory_.lend(s, work_);
    }

    void step(StepControl& control) override {
        place_walls(control.step);
        std::fill(tallies_.begin(), tallies_.end(), TileTally{});
        const auto parts = static_cast<int>(plan_.parts().size());
        if (threads_ == 1 || parts == 1) {
            step_of_thread(0, parts, [] {});
        } else {
            const int threads = std::min(threads_, parts);
#pragma omp parallel num_threads(threads)
            {
                const int t = omp_get_thread_num(), count = omp_get_num_threads();
                step_of_thread(t * parts / count, (t + 1) * parts / count, [] {
#pragma omp barrier
                });
            }
        }
        for (const TileTally& tally : tallies_) {
            control.peak[0] = std::max(control.peak[0], tally.largest_overlap);
            control.peak[1] = std::max(control.peak[1], tally.largest_square);
        }
        if (!(control.peak[1] < fastest_ * fastest_)) control.peak[1] = std::numeric_limits<double>::infinity();
        control.peak[2] = control.peak[1];
    }

    void end() override {
        memory_.give_back(*snapshot_);
        snapshot_ = nullptr;
    }

private:
    void place_walls(std::int64_t step) {
        for (std::size_t w = 0; w < walls_.size(); ++w) {
            const Vec3 way = anchors_[w].way(step, setup_.time_step);
            walls_[w].point = anchors_[w].point + way;
            walls_[w].lower = anchors_[w].lower + way;
            walls_[w].upper = anchors_[w].upper + way;
        }
    }

    /// The parts [begin, end) of a step. Particles that an earlier part of another thread reaches wait for that.
    template <class Barrier>
    void step_of_thread(int begin, int end, const Barrier& barrier) {
        const FlushDenormals flush;
        const auto from = static_cast<std::size_t>(begin), to = static_cast<std::size_t>(end);
        std::vector<TilePart>& parts = plan_.parts();
        const auto inner = [&](std::size_t p) { return parts[p].first_before >= from; };
        for (std::size_t p = from; p < to; ++p) {
            std::fill(parts[p].near.begin(), parts[p].near.end(), 0);
            parts[p].near_particles = 0;
            over_tiles(parts[p], [&](TileRange tile) {
                touch(p, tile);
                if (inner(p)) advance(p, tile);
            });
        }
        barrier();
        for (std::size_t p = from; p < to; ++p)
            if (!inner(p)) over_tiles(parts[p], [&](TileRange tile) { advance(p, tile); });
        if constexpr (Variant::cohesive) {
            barrier();
            for (std::size_t p = from; p < to; ++p) attract(p, kernels_.near);
            for (int pass = 0; pass < corrections_; ++pass) {
                barrier();
                for (std::size_t p = from; p < to; ++p) {
                    absorb_near(p);
                    kernels_.foresee(work_, near_particles(parts[p]));
                }
                barrier();
                for (std::size_t p = from; p < to; ++p) attract(p, kernels_.correct);
            }
            barrier();
            for (std::size_t p = from; p < to; ++p) {
                absorb_near(p);
                kernels_.finish(work_, near_particles(parts[p]), tallies_[p]);
            }
        }
    }

    template <class Function>
    static void over_tiles(const TilePart& part, const Function& f) {
        for (std::size_t i = part.particles.begin; i < part.particles.end; i += TilePlan::tile)
            f(TileRange{i, std::min(i + TilePlan::tile, part.particles.end)});
    }

    /// Contacts of the particles of `tile` with segment 0, pairs in which they are the first, or wall `segment` - 1.
    [[nodiscard]] TileRange contacts_of(std::size_t segment, TileRange tile) const {
        const std::int32_t* offsets = snapshot_->contacts.offsets.data() + segment * snapshot_->awake;
        return {static_cast<std::size_t>(offsets[tile.begin]), static_cast<std::size_t>(offsets[tile.end])};
    }

    [[nodiscard]] const Wall* wall_of(std::size_t segment) const {
        return segment > 0 ? &walls_[segment - 1] : nullptr;
    }

    void touch(std::size_t p, TileRange tile) {
        TilePart& part = plan_.parts()[p];
        for (std::size_t segment = 0; segment <= walls_.size(); ++segment) {
            const TileRange range = contacts_of(segment, tile);
            if (range.begin == range.end) continue;
            const std::size_t near = contacts_of(segment, part.particles).begin + part.near[segment];
            kernels_.contacts(work_, wall_of(segment), range, near, tallies_[p]);
            part.near[segment] += tallies_[p].near;
        }
    }

    void advance(std::size_t p, TileRange tile) {
        TilePart& part = plan_.parts()[p];
        for (std::size_t q = part.first_before; q < p; ++q) absorb<0, numbers>(plan_.parts()[q], tile);
        kernels_.particles(work_, tile, part.particles.begin + part.near_particles, tallies_[p]);
        part.near_particles += tallies_[p].near_particles;
    }

    /// Adds `count` numbers from the one at `first` on of what an earlier part has added up for the particles of
    /// `tile`.
    template <int first, int count>
    void absorb(TilePart& earlier, TileRange tile) {
        const auto begin = earlier.reached.begin();
        auto at = std::lower_bound(begin, earlier.reached.end(), static_cast<std::int32_t>(tile.begin));
        double* more = earlier.sums.data() + numbers * (at - begin) + first;
        for (; at != earlier.reached.end() && static_cast<std::size_t>(*at) < tile.end; ++at, more += numbers) {
            double* sums = work_.sums + numbers * static_cast<std::size_t>(*at) + first;
            for (int k = 0; k < count; ++k) {
                sums[k] += more[k];
                more[k] = 0;
            }
        }
    }

    /// What the attraction of near contacts has added since.
    void absorb_near(std::size_t p) {
        const TilePart& part = plan_.parts()[p];
        for (std::size_t q = part.first_before; q < p; ++q) {
            TilePart& earlier = plan_.parts()[q];
            if (earlier.any_near()) absorb<SumLayout<Variant>::attraction, 4>(earlier, part.particles);
        }
    }

    /// Its particles with near contacts, as the loops have listed them.
    [[nodiscard]] static TileRange near_particles(const TilePart& part) {
        return {part.particles.begin, part.particles.begin + part.near_particles};
    }

    void attract(std::size_t p, decltype(TileKernels<Variant>::near) solve) {
        TilePart& part = plan_.parts()[p];
        for (std::size_t segment = 0; segment <= walls_.size(); ++segment) {
            if (part.near[segment] == 0) continue;
            const std::size_t begin = contacts_of(segment, part.particles).begin;
            solve(work_, wall_of(segment), {begin, begin + part.near[segment]});
        }
    }

    EngineSetup setup_;
    TileKernels<Variant> kernels_;
    int threads_;
    int corrections_ = 0;
    double fastest_;  ///< speed beyond which a run stops [m/s]
    TileWork<Variant> work_{};
    Snapshot* snapshot_ = nullptr;
    std::int64_t lists_ = -1;  ///< for which all below has been made
    std::vector<Wall> walls_;
    std::vector<WallAnchor> anchors_;
    TilePlan plan_;
    std::vector<TileTally> tallies_;
    TileMemory<Variant> memory_;
};

/// Calls f(std::bool_constant).
template <class Function>
auto with_constant(bool value, const Function& f) {
    return value ? f(std::true_type()) : f(std::false_type());
}

}  // namespace

std::unique_ptr<TileStepper> make_tile_stepper(const EngineSetup& setup, double radius, double smallest) {
    using Made = std::unique_ptr<TileStepper>;
    const bool is_cohesive = setup.model.hamaker > 0, is_relative = setup.model.rolling_form == RollingForm::relative;
    return with_constant(radius > 0, [&](auto equal) {
        return with_constant(is_cohesive, [&](auto cohesive) {
            return with_constant(is_relative, [&](auto relative) -> Made {
                if (setup.precision == Precision::mixed)
                    return std::make_unique<Stepper<TileVariant<equal, cohesive, relative, float>>>(setup, radius,
                                                                                                    smallest);
                return std::make_unique<Stepper<TileVariant<equal, cohesive, relative, double>>>(setup, radius,
                                                                                                 smallest);
            });
        });
    });
}

}  // namespace recoat
