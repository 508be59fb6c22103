#pragma once

#include <atomic>

#include "solver/engine/quiet.hpp"
#include "solver/engine/wall_separation.hpp"

namespace recoat {

/// Sets a flag, as several threads may at the same time.
RECOAT_HD void set_flag(std::int32_t* flag) {
#ifdef __CUDA_ARCH__
    *flag = 1;
#else
    std::atomic_ref<std::int32_t>(*flag).store(1, std::memory_order_relaxed);
#endif
}

/// Finds particles that a moving wall is near.
struct MovingWallSearch {
    const WallAnchor* wall;
    std::size_t walls;
    std::int64_t step;
    double time_step;
    double within;  ///< [m]

    RECOAT_HD bool near(const Row& particle) const {
        for (std::size_t w = 0; w < walls; ++w)
            if (wall[w].active && squared_norm(wall[w].velocity) > 0 &&
                wall_separation(wall[w], step, time_step, particle) < within)
                return true;
        return false;
    }
};

/// For every pair of the far list of which one is marked in `from`: marks the other in `to`. Marked are only some of
/// the first `count` particles.
template <class Space>
void mark_neighbours(Space& space, const FarList<Space>& far, std::size_t count, const std::int32_t* from,
                     std::int32_t* to) {
    const std::int32_t *begin = far.begin.data(), *second = far.second.data();
    space.for_each(count, [=] RECOAT_LAMBDA(std::size_t i) {
        for (std::int32_t e = begin[i]; e < begin[i + 1]; ++e) {
            const std::int32_t j = second[e];
            if (from[i] != 0) set_flag(to + j);
            if (from[j] != 0) set_flag(to + i);
        }
    });
}

/// Chooses who sleeps: quiet particles that have only quiet ones in their far list, as have all of these, and no moving
/// wall near.
template <class Space>
class SleepChoice {
public:
    template <class T>
    using Array = typename Space::template Array<T>;

    /// Layers that wake around a particle that has been quiet beside a sleeper and no longer is: there will be more,
    /// and every choice costs a sort.
    static constexpr int layers_woken = 3;

    /// Returns the number of sleepers; `asleep()` are their flags, [N].
    std::size_t choose(Space& space, const SnapshotOf<Space>& s, const FarList<Space>& far, const Quiet& quiet,
                       const MovingWallSearch& walls) {
        const std::size_t n = s.particles.size();
        for (Array<std::int32_t>* flags : {&moving_, &kept_, &asleep_}) flags->resize(n);
        std::int32_t *moving = moving_.data(), *kept = kept_.data(), *asleep = asleep_.data();
        const Row* position = s.particles.position.data();
        space.for_each(n, [=] RECOAT_LAMBDA(std::size_t i) {
            moving[i] = quiet(i) ? 0 : 1;
            kept[i] = moving[i] != 0 || walls.near(position[i]) ? 1 : 0;
        });
        // Two layers of guards between what moves and what sleeps.
        mark_neighbours(space, far, s.awake, moving, kept);
        space.copy(kept_, asleep_);
        mark_neighbours(space, far, n, asleep, kept);
        if (s.awake < n) wake_layers(space, s, far, quiet);
        space.for_each(n, [=] RECOAT_LAMBDA(std::size_t i) { asleep[i] = 1 - kept[i]; });
        return static_cast<std::size_t>(
            space.sum(n, [=] RECOAT_LAMBDA(std::size_t i) { return static_cast<double>(asleep[i]); }));
    }

    [[nodiscard]] const std::int32_t* asleep() const { return asleep_.data(); }

    void wake_layers(Space& space, const SnapshotOf<Space>& s, const FarList<Space>& far, const Quiet& quiet) {
        const std::size_t n = s.particles.size();
        const DisturbedGuard disturbed(s, quiet);
        std::int32_t *woken = moving_.data(), *kept = kept_.data();
        space.for_each(n, [=] RECOAT_LAMBDA(std::size_t i) { woken[i] = disturbed(i) ? 1 : 0; });
        for (int layer = 0; layer < layers_woken; ++layer) {
            space.copy(moving_, asleep_);
            mark_neighbours(space, far, n, asleep_.data(), moving_.data());
        }
        space.for_each(n, [=] RECOAT_LAMBDA(std::size_t i) { kept[i] |= woken[i]; });
    }

private:
    Array<std::int32_t> moving_, kept_, asleep_;
};

}  // namespace recoat
