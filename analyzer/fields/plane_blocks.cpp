#include "analyzer/fields/plane_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>

namespace recoat {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
/// Beyond the margin, lest round-off leaves out what lies on its end [d_p].
constexpr double slack = 2e-3;
/// Disks of a block, about: its triangulation stays in the cache.
constexpr double usual_disks = 3000;
/// Side of a block over the margin, at least: most disks then belong to one block only.
constexpr double least_margins = 8;

struct Extent {
    double low, high;

    explicit Extent(const TopView& view) {
        const auto [first, last] = std::ranges::minmax(view.disks, {}, &Disk::x);
        low = first.x;
        high = last.x;
    }
    [[nodiscard]] double length() const { return high - low; }
};

/// Blocks of equal size.
class Layout {
public:
    Layout(const TopView& view, double margin)
        : view_(view), extent_(view), margin_x_(margin + slack), margin_y_(std::min(margin, view.period / 2) + slack) {
        const double per_disk = extent_.length() * view.period / static_cast<double>(view.disks.size());
        const double side = std::max(std::sqrt(usual_disks * per_disk), least_margins * margin);
        const auto blocks = [&](double length) {
            return side > 0 ? static_cast<int>(std::max(1.0, std::min(length / side, 1e6))) : 1;
        };
        nx_ = blocks(extent_.length());
        ny_ = blocks(view.period);
        blocks_.resize(static_cast<std::size_t>(nx_) * ny_);
    }

    std::vector<PlaneBlock> run() {
        for (int i = 0; i < nx_; ++i) {
            for (int j = 0; j < ny_; ++j) {
                PlaneBlock& block = at(i, j);
                block.x_begin = i == 0 ? -infinite : edge_x(i);
                block.x_end = i == nx_ - 1 ? infinite : edge_x(i + 1);
                block.y_begin = edge_y(j);
                block.y_end = edge_y(j + 1);
            }
        }
        const int turns = static_cast<int>(std::ceil(margin_y_ / view_.period)) + 1;
        for (const Disk& disk : view_.disks) {
            for (int turn = -turns; turn <= turns; ++turn) add(disk, turn);
        }
        return std::move(blocks_);
    }

private:
    [[nodiscard]] PlaneBlock& at(int i, int j) { return blocks_[static_cast<std::size_t>(i) * ny_ + j]; }
    [[nodiscard]] double edge_x(int i) const { return extent_.low + extent_.length() * i / nx_; }
    [[nodiscard]] double edge_y(int j) const { return view_.period * j / ny_; }

    void add(Disk disk, int turn) {
        disk.y += turn * view_.period;
        disk.turn = turn;
        if (disk.y < -margin_y_ || disk.y > view_.period + margin_y_) return;
        const double width = extent_.length() / nx_, height = view_.period / ny_;
        const auto clipped = [](double place, int count) {
            return static_cast<int>(std::clamp(std::floor(place), 0.0, count - 1.0));
        };
        const int i_low = nx_ == 1 ? 0 : clipped((disk.x - extent_.low - margin_x_) / width - 1e-9, nx_);
        const int i_high = nx_ == 1 ? 0 : clipped((disk.x - extent_.low + margin_x_) / width + 1e-9, nx_);
        const int j_low = clipped((disk.y - margin_y_) / height - 1e-9, ny_);
        const int j_high = clipped((disk.y + margin_y_) / height + 1e-9, ny_);
        for (int i = i_low; i <= i_high; ++i) {
            for (int j = j_low; j <= j_high; ++j) at(i, j).disks.push_back(disk);
        }
    }

    const TopView& view_;
    Extent extent_;
    double margin_x_, margin_y_;
    int nx_ = 1, ny_ = 1;
    std::vector<PlaneBlock> blocks_;
};

/// Square cells over the disks, about two for each, and how many steps to a cell with a centre.
class CellDistance {
public:
    explicit CellDistance(const TopView& view) {
        const Extent extent(view);
        const double count = 2 * static_cast<double>(view.disks.size()) + 1;
        side_ =
            std::max({std::sqrt(extent.length() * view.period / count), extent.length() / count, view.period / count});
        nx_ = static_cast<std::size_t>(extent.length() / side_) + 1;
        ny_ = static_cast<std::size_t>(std::ceil(view.period / side_));
        steps_.assign(nx_ * ny_, unknown);
        for (const Disk& disk : view.disks) {
            const auto i = std::min(static_cast<std::size_t>((disk.x - extent.low) / side_), nx_ - 1);
            const auto j = std::min(static_cast<std::size_t>(std::max(disk.y, 0.0) / side_), ny_ - 1);
            if (std::exchange(steps_[i * ny_ + j], 0) == unknown) front_.push_back(i * ny_ + j);
        }
    }

    double bound() {
        std::uint32_t steps = 0;
        for (; !front_.empty(); ++steps) spread(steps + 1);
        // The last round found nothing. The last cells of a period may be cut off: one step is no more than a side.
        return static_cast<double>(steps) * side_ * std::numbers::sqrt2;
    }

private:
    static constexpr std::uint32_t unknown = std::numeric_limits<std::uint32_t>::max();

    void spread(std::uint32_t steps) {
        std::vector<std::size_t> next;
        for (const std::size_t cell : front_) {
            const std::size_t i = cell / ny_, j = cell % ny_;
            for (std::size_t a = i == 0 ? 0 : i - 1; a <= std::min(i + 1, nx_ - 1); ++a) {
                for (const std::size_t b : {j == 0 ? ny_ - 1 : j - 1, j, j == ny_ - 1 ? 0 : j + 1}) {
                    std::uint32_t& there = steps_[a * ny_ + b];
                    if (there != unknown) continue;
                    there = steps;
                    next.push_back(a * ny_ + b);
                }
            }
        }
        front_ = std::move(next);
    }

    double side_ = 1;
    std::size_t nx_ = 1, ny_ = 1;
    std::vector<std::uint32_t> steps_;
    std::vector<std::size_t> front_;
};

}  // namespace

std::vector<PlaneBlock> plane_blocks(const TopView& view, double margin) { return Layout(view, margin).run(); }

double farthest_from_centres(const TopView& view) { return CellDistance(view).bound(); }

}  // namespace recoat
