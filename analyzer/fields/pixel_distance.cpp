#include "analyzer/fields/pixel_distance.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <tbb/parallel_for.h>

namespace recoat {
namespace {

/// A centre this close outside a disk counts as inside, whatever the round-off [d_p].
constexpr double rim = 1e-9;

void fill_solid(const Layer& layer, int n, PixelDistance& pixels) {
    for (std::size_t p = 0; p < layer.size(); ++p) {
        const double radius = layer.radius[p] + rim;
        const int first = std::max(static_cast<int>(std::floor((layer.x[p] - radius) * n)), pixels.i_begin);
        const int last =
            std::min(static_cast<int>(std::ceil((layer.x[p] + radius) * n)), pixels.i_begin + pixels.nx - 1);
        for (int i = first; i <= last; ++i) {
            const double dx = (i + 0.5) / n - layer.x[p], left = radius * radius - dx * dx;
            if (left < 0) continue;
            const double half = std::sqrt(left);
            const auto low = static_cast<std::int64_t>(std::ceil((layer.y[p] - half) * n - 0.5));
            const auto high = static_cast<std::int64_t>(std::floor((layer.y[p] + half) * n - 0.5));
            for (std::int64_t j = low; j <= std::min(high, low + pixels.ny - 1); ++j) {
                const std::int64_t wrapped = ((j % pixels.ny) + pixels.ny) % pixels.ny;
                pixels.squared[static_cast<std::size_t>(i - pixels.i_begin) * pixels.ny + wrapped] = 0;
            }
        }
    }
}

/// Squared distance along a row, twice round the period each way.
void along_y(std::int64_t* row, int ny) {
    std::int64_t distance = PixelDistance::infinite;
    std::vector<std::int64_t> nearest(ny, PixelDistance::infinite);
    const auto step = [&](int j) {
        if (row[j] == 0) distance = 0;
        nearest[j] = std::min(nearest[j], distance);
        if (distance < PixelDistance::infinite) ++distance;
    };
    for (int j = 0; j < 2 * ny; ++j) step(j % ny);
    distance = PixelDistance::infinite;
    for (int j = 2 * ny - 1; j >= 0; --j) step(j % ny);
    for (int j = 0; j < ny; ++j) {
        row[j] = nearest[j] < PixelDistance::infinite ? nearest[j] * nearest[j] : PixelDistance::infinite;
    }
}

/// Lower envelope of the parabolas over a column (Felzenszwalb and Huttenlocher 2012).
class Envelope {
public:
    void apply(PixelDistance& pixels, int j) {
        apex_.clear();
        from_.clear();
        for (int i = 0; i < pixels.nx; ++i) {
            const std::int64_t height = pixels.squared[static_cast<std::size_t>(i) * pixels.ny + j];
            if (height < PixelDistance::infinite) insert({i, height});
        }
        if (apex_.empty()) return;
        std::size_t k = 0;
        for (int i = 0; i < pixels.nx; ++i) {
            while (k + 1 < apex_.size() && from_[k + 1] <= i) ++k;
            const std::int64_t step = i - apex_[k].i;
            pixels.squared[static_cast<std::size_t>(i) * pixels.ny + j] = apex_[k].height + step * step;
        }
    }

private:
    struct Apex {
        std::int64_t i, height;
    };

    void insert(Apex apex) {
        double from = -1e300;
        while (!apex_.empty()) {
            const Apex& last = apex_.back();
            from = static_cast<double>(apex.height + apex.i * apex.i - last.height - last.i * last.i) /
                   static_cast<double>(2 * (apex.i - last.i));
            if (from > from_.back()) break;
            apex_.pop_back();
            from_.pop_back();
            from = -1e300;
        }
        apex_.push_back(apex);
        from_.push_back(from);
    }

    std::vector<Apex> apex_;
    std::vector<double> from_;
};

}  // namespace

PixelDistance pixel_distance(const Layer& layer, int pixels_per_dp, double margin) {
    PixelDistance pixels;
    const int n = pixels_per_dp;
    pixels.i_begin = -static_cast<int>(std::ceil(margin * n));
    pixels.nx = static_cast<int>(std::ceil((layer.length + margin) * n)) - pixels.i_begin;
    pixels.ny = static_cast<int>(std::lround(layer.width * n));
    pixels.squared.assign(static_cast<std::size_t>(pixels.nx) * pixels.ny, PixelDistance::infinite);
    fill_solid(layer, n, pixels);
    tbb::parallel_for(0, pixels.nx, [&](int i) {
        along_y(pixels.squared.data() + static_cast<std::size_t>(i) * pixels.ny, pixels.ny);
    });
    tbb::parallel_for(0, pixels.ny, [&](int j) { Envelope().apply(pixels, j); });
    return pixels;
}

}  // namespace recoat
