#include "solver/output/blade_stop.hpp"

#include <algorithm>
#include <functional>

namespace recoat {
namespace {

constexpr double least_way = 0.05;  ///< d_p

/// Where a sphere was in part between its place at the stop and its place now.
struct Track {
    double lower = 0, upper = 0;  ///< [m]
};

std::vector<Track> tracks_backwards(const BladeStop& stop, const ParticleTable& now, double diameter) {
    std::vector<Track> tracks;
    for (std::size_t i = 0; i < now.size(); ++i) {
        const double x = now.position[i].x, radius = now.radius[i];
        if (stop.x[i] - x >= least_way * diameter) tracks.push_back({x - radius, stop.x[i] + radius});
    }
    std::ranges::sort(tracks, std::greater{}, &Track::upper);
    return tracks;
}

}  // namespace

double layer_end(const BladeStop& stop, const ParticleTable& now, double diameter) {
    double end = stop.rear;
    // Tracks that reach less far forward than the end, and so all after them, cannot move it.
    for (const Track& track : tracks_backwards(stop, now, diameter)) {
        if (track.upper <= end) break;
        end = std::min(end, track.lower);
    }
    return end;
}

}  // namespace recoat
