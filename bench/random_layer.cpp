#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/os.h>

#include "common/error.hpp"

namespace {

using namespace recoat;

/// What is written: a layer of so many spheres over a length x width.
struct Recipe {
    std::size_t particles = 14'000;
    double length = 549, width = 40;  ///< [d_p]
    double spread = 0;                ///< standard deviation of the logarithm of the radius
    int trials = 8;
    std::uint64_t seed = 1;
};

struct Sphere {
    double x, y, z, radius;  ///< [d_p]
};

/// The same numbers on every machine (splitmix64).
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    double uniform() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
    }
    double normal() {
        const double radius = std::sqrt(-2 * std::log(1 - uniform()));
        return radius * std::cos(2 * std::numbers::pi * uniform());
    }

private:
    std::uint64_t state_;
};

/// Spheres fall straight down one after the other and stay where they touch: at the lowest of some random places. So
/// most come to lie on the base, some on others, none overlap, and neighbours in space are far apart in the file.
class Deposition {
public:
    explicit Deposition(const Recipe& recipe)
        : recipe_(recipe),
          random_(recipe.seed),
          nx_(std::max(1, static_cast<int>(recipe.length / side))),
          ny_(std::max(1, static_cast<int>(recipe.width / side))),
          boxes_(static_cast<std::size_t>(nx_) * ny_) {}

    std::vector<Sphere> run() {
        for (std::size_t i = 0; i < recipe_.particles; ++i) {
            Sphere best = place();
            for (int trial = 1; trial < recipe_.trials; ++trial) {
                Sphere other = place();
                if (other.z - other.radius < best.z - best.radius) best = other;
            }
            boxes_[box(column(best.x), row(best.y))].push_back(best);
            spheres_.push_back(best);
        }
        return std::move(spheres_);
    }

private:
    /// Side of the boxes [d_p]: two spheres touch only in neighbouring ones.
    static constexpr double side = 2;

    [[nodiscard]] int column(double x) const { return std::min(static_cast<int>(x / recipe_.length * nx_), nx_ - 1); }
    [[nodiscard]] int row(double y) const { return std::min(static_cast<int>(y / recipe_.width * ny_), ny_ - 1); }
    [[nodiscard]] std::size_t box(int i, int j) const { return static_cast<std::size_t>(i) * ny_ + (j + ny_) % ny_; }

    /// A sphere over a random place, let down.
    Sphere place() {
        const double radius = 0.5 * std::exp(std::clamp(recipe_.spread * random_.normal(), -0.6, 0.6));
        Sphere sphere = {random_.uniform() * recipe_.length, random_.uniform() * recipe_.width, radius, radius};
        for (int i = std::max(column(sphere.x) - 1, 0); i <= std::min(column(sphere.x) + 1, nx_ - 1); ++i) {
            for (int j = row(sphere.y) - 1; j <= row(sphere.y) + 1; ++j) {
                for (const Sphere& other : boxes_[box(i, j)]) {
                    const double dx = sphere.x - other.x, gap_y = std::abs(sphere.y - other.y);
                    const double dy = std::min(gap_y, recipe_.width - gap_y), reach = radius + other.radius;
                    const double left = reach * reach - dx * dx - dy * dy;
                    if (left > 0) sphere.z = std::max(sphere.z, other.z + std::sqrt(left));
                }
            }
        }
        return sphere;
    }

    const Recipe& recipe_;
    Random random_;
    int nx_, ny_;
    std::vector<std::vector<Sphere>> boxes_;
    std::vector<Sphere> spheres_;
};

}  // namespace

/// Writes a random layer as CSV (x,y,z,radius in metres, d_p = 50 um): the same file for the same recipe everywhere.
int main(int argc, char** argv) {
    Recipe recipe;
    std::string out;
    CLI::App app("A random layer of spheres");
    app.add_option("out", out, "CSV file to write")->required();
    app.add_option("--particles", recipe.particles, "number of spheres");
    app.add_option("--length", recipe.length, "[d_p]");
    app.add_option("--width", recipe.width, "period in y [d_p]")->check(CLI::Range(6.0, 1e6));
    app.add_option("--spread", recipe.spread, "standard deviation of the logarithm of the radius")
        ->check(CLI::Range(0.0, 0.5));
    app.add_option("--trials", recipe.trials, "places of which a sphere takes the lowest");
    app.add_option("--seed", recipe.seed, "seed");
    CLI11_PARSE(app, argc, argv);
    return run_program("random-layer", [&] {
        constexpr double diameter = 5e-5;
        auto file = fmt::output_file(out);
        file.print("x,y,z,radius\n");
        for (const Sphere& s : Deposition(recipe).run()) {
            file.print("{:.12e},{:.12e},{:.12e},{:.12e}\n", s.x * diameter, s.y * diameter, s.z * diameter,
                       s.radius * diameter);
        }
        return 0;
    });
}
