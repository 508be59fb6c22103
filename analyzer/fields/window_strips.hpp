#pragma once

#include <cmath>

namespace recoat {

/// Divides a line into the strips between the edges of all windows of a row of nodes, so that every window is a whole
/// run of strips: one strip per node spacing if the windows end where others begin, two otherwise.
///
/// Window i covers [edge(first(i)), edge(first(i) + per_window())]. Strips are numbered from the lower edge of window 0
/// and go on without end to both sides; the caller drops or wraps what lies outside.
class WindowStrips {
public:
    /// @param spacing, window nominal sides [d_p], both `stretch` times as long in truth
    WindowStrips(double spacing, double window, double stretch)
        : spacing_(spacing * stretch), origin_(0.5 * (spacing - window) * stretch) {
        const double spacings = window / spacing;
        const double whole = std::floor(spacings + alignment);
        const double rest = spacings - whole;
        aligned_ = rest <= alignment;
        fraction_ = aligned_ ? 0 : rest;
        per_window_ = static_cast<int>(whole) * per_spacing() + (aligned_ ? 0 : 1);
    }

    [[nodiscard]] int per_spacing() const { return aligned_ ? 1 : 2; }
    [[nodiscard]] int per_window() const { return per_window_; }
    [[nodiscard]] int first(int node) const { return node * per_spacing(); }

    /// Lower edge of a strip.
    [[nodiscard]] double edge(int strip) const {
        if (aligned_) return origin_ + spacing_ * strip;
        const int turn = static_cast<int>(std::floor(strip / 2.0));
        return origin_ + spacing_ * (turn + (strip - 2 * turn) * fraction_);
    }

    /// Strip that holds `position`; one within `tolerance` below an edge counts as on it.
    [[nodiscard]] int strip_of(double position, double tolerance = 0) const {
        const double turns = (position + tolerance - origin_) / spacing_;
        const double whole = std::floor(turns);
        return static_cast<int>(whole) * per_spacing() + (!aligned_ && turns - whole >= fraction_ ? 1 : 0);
    }

private:
    static constexpr double alignment = 1e-9;
    double spacing_, origin_, fraction_ = 0;
    bool aligned_ = true;
    int per_window_ = 0;
};

}  // namespace recoat
