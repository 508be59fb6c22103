#include "solver/scene/join_boxes.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string>

namespace recoat {
namespace {

/// Walls that a stage moves or takes away.
std::set<std::string> walls_in(const std::vector<Stage>& stages) {
    std::set<std::string> names;
    for (const Stage& stage : stages) {
        for (const Segment& segment : stage.segments) {
            names.insert(segment.removed.begin(), segment.removed.end());
            for (const WallMotion& motion : segment.motions) names.insert(motion.wall);
        }
    }
    return names;
}

/// The box that both are together, if they are one.
std::optional<Wall> joined(const Wall& a, const Wall& b) {
    constexpr std::array<double Vec3::*, 3> axes = {&Vec3::x, &Vec3::y, &Vec3::z};
    int different = 0;
    bool apart = false;
    Wall both = a;
    for (const auto axis : axes) {
        const bool same = a.lower.*axis == b.lower.*axis && a.upper.*axis == b.upper.*axis;
        if (same) continue;
        ++different;
        apart = std::max(a.lower.*axis, b.lower.*axis) > std::min(a.upper.*axis, b.upper.*axis);
        both.lower.*axis = std::min(a.lower.*axis, b.lower.*axis);
        both.upper.*axis = std::max(a.upper.*axis, b.upper.*axis);
    }
    if (different > 1 || apart) return {};
    both.name = a.name + " and " + b.name;
    return both;
}

/// Joins the first two walls that are one box together; false where there are none.
template <class Stays>
bool join_two(std::vector<Wall>& walls, const Stays& stays) {
    for (std::size_t i = 0; i < walls.size(); ++i) {
        for (std::size_t j = i + 1; j < walls.size(); ++j) {
            if (!stays(walls[i]) || !stays(walls[j])) continue;
            const std::optional<Wall> both = joined(walls[i], walls[j]);
            if (!both) continue;
            walls[i] = *both;
            walls.erase(walls.begin() + static_cast<std::ptrdiff_t>(j));
            return true;
        }
    }
    return false;
}

}  // namespace

std::vector<Wall> join_boxes(std::vector<Wall> walls, const std::vector<Stage>& stages) {
    const std::set<std::string> moved = walls_in(stages);
    const auto stays = [&](const Wall& wall) {
        return wall.kind == WallKind::box && wall.velocity == Vec3{} && !moved.contains(wall.name);
    };
    // A box that was joined may meet others that its parts did not: rows of tiles become a floor.
    while (join_two(walls, stays)) continue;
    return walls;
}

}  // namespace recoat
