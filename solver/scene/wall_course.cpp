#include "solver/scene/wall_course.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "solver/scene/scene.hpp"

namespace recoat {
namespace {

constexpr std::array<std::string_view, 3> ends = {"base", "rear", "front"};

void shift(Wall& wall, Vec3 way) {
    wall.point += way;
    wall.lower += way;
    wall.upper += way;
}

/// Along one axis, how far the box reaches against the normal of the plane; an infinite side reaches everywhere.
double least(double normal, double lower, double upper, double point) {
    return normal == 0 ? 0 : std::min(normal * (lower - point), normal * (upper - point));
}

/// Gap between a plane and a box in front of it [m].
double gap_to_box(const Wall& plane, const Wall& box) {
    return least(plane.normal.x, box.lower.x, box.upper.x, plane.point.x) +
           least(plane.normal.y, box.lower.y, box.upper.y, plane.point.y) +
           least(plane.normal.z, box.lower.z, box.upper.z, plane.point.z);
}

/// "blade", "wall \"lid\"", "front end wall".
std::string word_for(const Wall& wall) {
    if (wall.name == "blade" || wall.name == "gate" || wall.name == "base") return wall.name;
    if (wall.name == "rear" || wall.name == "front") return wall.name + " end wall";
    return fmt::format("wall \"{}\"", wall.name);
}

bool face_each_other(const Wall& a, const Wall& b) { return dot(a.normal, b.normal) < -1 + 1e-12; }

/// Room between two walls [m]; infinite where they do not face each other.
double gap_between(const Wall& a, const Wall& b, bool with_boxes) {
    constexpr double none = std::numeric_limits<double>::infinity();
    const bool plane_a = a.kind == WallKind::plane, plane_b = b.kind == WallKind::plane;
    if (plane_a && plane_b) return face_each_other(a, b) ? dot(a.normal, b.point - a.point) : none;
    if (!with_boxes || plane_a == plane_b) return none;
    return plane_a ? gap_to_box(a, b) : gap_to_box(b, a);
}

}  // namespace

WallCourse::WallCourse(const Scene& scene)
    : bounded_(scene.spread.has_value()), time_step_(scene.time_step), diameter_(scene.diameter), walls_(scene.walls) {}

bool WallCourse::stands(std::string_view name) const {
    return std::ranges::any_of(walls_, [&](const Wall& wall) { return wall.active && wall.name == name; });
}

const Wall& WallCourse::wall(std::string_view name) const {
    const auto found = std::ranges::find(walls_, name, &Wall::name);
    if (found == walls_.end()) throw std::logic_error("no wall " + std::string(name));
    return *found;
}

std::string WallCourse::remove(const std::string& name) {
    if (bounded_ && std::ranges::find(ends, name) != ends.end())
        return fmt::format(
            "the domain ends at the wall \"{}\", so particles beyond it would be lost; leave it where it is", name);
    for (Wall& wall : walls_) {
        if (wall.name == name) wall.active = false;
    }
    return {};
}

/// Heights are measured from the base, and the domain ends at the end walls.
std::string WallCourse::leaves_domain(const Wall& wall) const {
    if (!bounded_) return {};
    if (wall.name == "base" && wall.velocity.z != 0)
        return "the wall \"base\" may move along x and y only: the domain ends below it, so particles would be lost, "
               "and "
               "heights are measured from it; move the blade instead";
    const bool outwards = (wall.name == "rear" && wall.velocity.x < 0) || (wall.name == "front" && wall.velocity.x > 0);
    if (!outwards) return {};
    return fmt::format(
        "the domain ends at the wall \"{}\", so particles that follow it outwards would be lost; give a longer "
        "box instead",
        wall.name);
}

std::string WallCourse::meeting(const std::vector<Wall>& before) const {
    for (std::size_t i = 0; i < walls_.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (!walls_[i].active || !walls_[j].active) continue;
            const double was = gap_between(before[i], before[j], bounded_);
            const double is = gap_between(walls_[i], walls_[j], bounded_);
            const double tolerance = 1e-9 * diameter_;
            if (!(is < -tolerance && is < was - tolerance)) continue;
            const bool moves = norm(walls_[i].velocity) > 0;
            const Wall &mover = moves ? walls_[i] : walls_[j], &other = moves ? walls_[j] : walls_[i];
            const bool at_end = bounded_ && (other.name == "front" || other.name == "rear");
            return fmt::format("the {} would run into the {}, {:.4g} dp too far; {}", word_for(mover), word_for(other),
                               -is / diameter_,
                               at_end ? "give a longer box.length or a shorter way"
                                      : "give a shorter way, or take one of them away before");
        }
    }
    return {};
}

std::string WallCourse::follow(const Segment& segment) {
    for (const std::string& name : segment.removed) {
        if (std::string problem = remove(name); !problem.empty()) return problem;
    }
    for (const WallMotion& motion : segment.motions) {
        for (Wall& wall : walls_) {
            if (wall.name == motion.wall) wall.velocity = motion.velocity;
        }
    }
    const std::vector<Wall> before = walls_;
    const double time = static_cast<double>(segment.steps) * time_step_;
    for (Wall& wall : walls_) {
        if (std::string problem = leaves_domain(wall); !problem.empty()) return problem;
        shift(wall, time * wall.velocity);
    }
    // Gaps change at a constant rate, so their least is at an end of the segment.
    std::string problem = meeting(before);
    for (const WallMotion& motion : segment.motions) {
        for (Wall& wall : walls_) {
            if (wall.name == motion.wall) wall.velocity = {};
        }
    }
    return problem;
}

}  // namespace recoat
