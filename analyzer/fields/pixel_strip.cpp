#include "analyzer/fields/pixel_strip.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace recoat {
namespace {

class StripMerger {
public:
    StripMerger(const PixelDistance& pixels, double height)
        : pixels_(pixels),
          height_(height),
          basins_(pixel_basins(pixels)),
          set_(basins_.tops.size()),
          into_(basins_.tops.size()),
          border_(basins_.tops.size(), 0) {
        std::iota(set_.begin(), set_.end(), 0U);
        into_ = set_;
    }

    PixelStrip run(bool has_before, bool has_after) {
        const std::int64_t last_row = pixels_.rows - 1;
        if (has_before) touch_border(0);
        if (has_after) touch_border(last_row);
        std::sort(basins_.passes.begin(), basins_.passes.end());
        for (const PixelPass& pass : basins_.passes) join(pass);
        settle_rest();
        number_tops();
        if (has_before) strip_.first = border_of(0);
        if (has_after) strip_.last = border_of(last_row);
        strip_.has_solid = std::ranges::find(basins_.basin, PixelBasins::solid) != basins_.basin.end();
        return std::move(strip_);
    }

private:
    void touch_border(std::int64_t row) {
        for (std::int64_t j = 0; j < pixels_.columns; ++j) {
            const auto p = static_cast<std::size_t>(row * pixels_.columns + j);
            if (basins_.basin[p] == PixelBasins::solid) continue;
            std::uint32_t& highest = border_[basins_.basin[p]];
            highest = std::max(highest, pixels_.squared[p]);
        }
    }
    std::uint32_t find(std::uint32_t basin) {
        while (set_[basin] != basin) basin = set_[basin] = set_[set_[basin]];
        return basin;
    }
    [[nodiscard]] std::uint32_t height_of(std::uint32_t set) const { return basins_.tops[set].squared; }

    /// The root of a set is the basin with its highest top. `border_` of the root: highest pixel of the set in a
    /// border, or `open` when a meeting of it has been left to be judged later.
    void join(const PixelPass& pass) {
        std::uint32_t elder = find(pass.first), younger = find(pass.second);
        if (elder == younger) return;
        if (height_of(elder) < height_of(younger)) std::swap(elder, younger);
        const bool same_height = height_of(elder) == height_of(younger);
        const bool plateau = same_height && height_of(elder) == pass.squared;
        if (same_height && border_[younger] >= pass.squared) std::swap(elder, younger);
        const bool closed = border_[younger] < pass.squared;
        set_[younger] = elder;
        if (closed && plateau) {
            basins_.tops[elder].absorb(basins_.tops[younger], pixels_.columns);
            into_[younger] = elder;
        } else if (closed && !same_height) {
            settle(younger, pass.squared);
            into_[younger] = elder;
        } else {
            strip_.passes.push_back({pass.squared, elder, younger});
            border_[elder] = open;
        }
        border_[elder] = std::max(border_[elder], border_[younger]);
    }
    void settle(std::uint32_t basin, std::uint32_t level) {
        if (falls_by(height_of(basin), level, height_)) strip_.maxima.push_back(basins_.tops[basin]);
    }

    /// Sets that touch no border and meet no other fall down to the solid.
    void settle_rest() {
        for (std::uint32_t basin = 0; basin < set_.size(); ++basin) {
            if (set_[basin] == basin && border_[basin] == 0) {
                settle(basin, 0);
                into_[basin] = gone;
            }
        }
    }
    void number_tops() {
        number_.assign(into_.size(), 0);
        for (std::uint32_t basin = 0; basin < into_.size(); ++basin) {
            if (into_[basin] != basin) continue;
            number_[basin] = static_cast<std::uint32_t>(strip_.tops.size());
            strip_.tops.push_back(basins_.tops[basin]);
        }
        for (PixelPass& pass : strip_.passes) {
            pass.first = number_[pass.first];
            pass.second = number_[pass.second];
        }
    }
    [[nodiscard]] PixelBorder border_of(std::int64_t row) const {
        PixelBorder border;
        for (std::int64_t j = 0; j < pixels_.columns; ++j) {
            const auto p = static_cast<std::size_t>(row * pixels_.columns + j);
            border.squared.push_back(pixels_.squared[p]);
            std::uint32_t basin = basins_.basin[p];
            if (basin != PixelBasins::solid) {
                while (into_[basin] != basin) basin = into_[basin];
                basin = number_[basin];
            }
            border.top.push_back(basin);
        }
        return border;
    }

    static constexpr std::uint32_t open = 0xFFFFFFFF, gone = 0xFFFFFFFF;

    const PixelDistance& pixels_;
    double height_;
    PixelBasins basins_;
    std::vector<std::uint32_t> set_, into_, border_, number_;
    PixelStrip strip_;
};

}  // namespace

bool falls_by(std::uint32_t from_squared, std::uint32_t to_squared, double height) {
    constexpr double round_off = 1e-7;
    return std::sqrt(static_cast<double>(from_squared)) - std::sqrt(static_cast<double>(to_squared)) >=
           height - round_off;
}

PixelStrip pixel_strip(const PixelDistance& pixels, double height, bool has_before, bool has_after) {
    return StripMerger(pixels, height).run(has_before, has_after);
}

}  // namespace recoat
