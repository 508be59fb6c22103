#include "tests/stress/draw_particles.hpp"

#include "common/number.hpp"

namespace recoat::stress {
namespace {

using Sphere = ParticleDraw::Sphere;

double draw_radius(Draw& draw, const ModelDraw& model) {
    const double largest = 0.5 * model.diameter;
    if (model.smallest == largest || draw.chance(0.2)) return model.smallest;
    return draw.chance(0.2) ? largest : draw.between(model.smallest, largest);
}

/// At random places: free of each other, or as they fall.
void scatter(Draw& draw, const ModelDraw& model, int count, double room, bool apart, ParticleDraw& made) {
    const double edge = model.diameter * std::cbrt(room * (count + 1));
    made.size = {edge, edge, edge};
    for (int k = 0; k < count; ++k) {
        Sphere sphere;
        sphere.radius = draw_radius(draw, model);
        for (int attempt = 0; attempt < 1000; ++attempt) {
            const auto place = [&] { return draw.between(sphere.radius, edge - sphere.radius); };
            sphere.position = {place(), place(), place()};
            bool free = true;
            for (const Sphere& other : made.spheres)
                free = free && norm(other.position - sphere.position) > sphere.radius + other.radius;
            if (free || !apart) break;
        }
        made.spheres.push_back(sphere);
    }
}

/// A block of equal spheres whose surfaces are `gap` apart.
void stack(const ModelDraw& model, int edge, double gap, ParticleDraw& made) {
    const double radius = 0.5 * model.diameter, pitch = model.diameter + gap;
    made.size = edge * pitch * Vec3{1, 1, 1};
    for (int k = 0; k < edge * edge * edge; ++k) {
        const Vec3 cell{static_cast<double>(k % edge), static_cast<double>(k / edge % edge),
                        static_cast<double>(k / (edge * edge))};
        made.spheres.push_back({pitch * cell + Vec3{radius, radius, radius}, {}, {}, radius});
    }
}

/// Exactly above faces, edges and corners of the block that scenes of this kind have at half their box.
void on_edges(Draw& draw, const ModelDraw& model, ParticleDraw& made) {
    const double radius = 0.5 * model.diameter, edge = 6 * model.diameter;
    made.size = {edge, edge, edge};
    for (const double x : {0.5, 0.25, 0.75}) {
        for (const double y : {0.5, 0.25, 0.75}) {
            const double height = 0.5 * edge + radius * draw.pick<double>({1, 1, 0.99, 1.001});
            made.spheres.push_back({{x * edge, y * edge, height}, {}, {}, radius});
        }
    }
}

void set_moving(Draw& draw, const ModelDraw& model, ParticleDraw& made) {
    const double heat = draw.chance(0.3) ? 0 : draw.chance(0.7) ? draw.decades(0.01, 1) : draw.decades(1, 100);
    const double spin = draw.chance(0.5) ? 0 : draw.chance(0.9) ? draw.decades(0.01, 10) : draw.decades(10, 1e6);
    for (Sphere& sphere : made.spheres) {
        const double speed = heat * model.speed * draw.unit();
        sphere.velocity = speed * draw.direction();
        const double rate = spin * model.speed / sphere.radius * draw.unit();
        sphere.spin = rate * draw.direction();
    }
    if (heat > 1) made.character += ", hot";
    if (spin > 10) made.character += ", spinning fast";
}

}  // namespace

std::string ParticleDraw::table() const {
    std::string text = "x,y,z,radius,vx,vy,vz,wx,wy,wz\n";
    for (const Sphere& s : spheres) {
        for (const double value : {s.position.x, s.position.y, s.position.z, s.radius, s.velocity.x, s.velocity.y,
                                   s.velocity.z, s.spin.x, s.spin.y})
            text += shortest(value) + ",";
        text += shortest(s.spin.z) + "\n";
    }
    return text;
}

ParticleDraw draw_particles(Draw& draw, const ModelDraw& model) {
    ParticleDraw made;
    const std::string kind = draw.pick<std::string>(
        {"apart", "apart", "apart", "overlapping", "touching", "one", "pair", "edges", "one place", "none"});
    made.character = kind;
    made.size = 4 * model.diameter * Vec3{1, 1, 1};
    const int count = draw.whole(2, 40), edge = draw.whole(2, 3);
    const double room = draw.decades(1.5, 20), depth = draw.decades(1e-5, 0.1) * model.diameter;
    if (kind == "apart") scatter(draw, model, count, room, true, made);
    if (kind == "overlapping") scatter(draw, model, (count + 1) / 2, 0.4 * room, false, made);
    if (kind == "one") scatter(draw, model, 1, 4, true, made);
    if (kind == "edges") on_edges(draw, model, made);
    if (kind == "touching")
        stack(model, edge, draw.pick<double>({0, 0, model.separation, model.cut_off, -1e-5 * model.diameter, -depth}),
              made);
    if (kind == "pair" || kind == "one place") {
        const double overlap = kind == "pair" ? draw.decades(1e-6, 0.2) * model.smallest : 2 * model.smallest;
        const Vec3 middle = 0.5 * made.size;
        made.spheres = {{middle, {}, {}, model.smallest},
                        {middle + (2 * model.smallest - overlap) * draw.direction(), {}, {}, model.smallest}};
    }
    set_moving(draw, model, made);
    return made;
}

}  // namespace recoat::stress
