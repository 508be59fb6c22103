#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "analyzer/analysis.hpp"
#include "analyzer/output/json_report.hpp"
#include "tests/analyzer/support.hpp"

namespace recoat {
namespace {

using testing::Ball;
using testing::layer_of;
using testing::random_balls;
using testing::unit_config;

using Json = nlohmann::ordered_json;

/// The first place where two reports differ by more than round-off; empty where they agree. Values in SI units are left
/// out: tests of units have them.
std::string difference(const Json& a, const Json& b, const std::string& place = "") {
    if (a.is_number() && b.is_number()) {
        const double x = a.get<double>(), y = b.get<double>();
        return std::abs(x - y) <= 1e-7 * std::max(1.0, std::abs(x)) ? "" : place + ": " + a.dump() + ", " + b.dump();
    }
    if (a.type() != b.type() || a.size() != b.size()) return place + ": " + a.dump().substr(0, 60);
    if (!a.is_structured()) return a == b ? "" : place;
    for (std::size_t k = 0; k < a.size(); ++k) {
        const auto one = std::next(a.begin(), static_cast<std::ptrdiff_t>(k)),
                   other = std::next(b.begin(), static_cast<std::ptrdiff_t>(k));
        const std::string key = a.is_object() ? one.key() : std::to_string(k);
        if (key == "config" || key.ends_with("_m2") || key.ends_with("_m3")) continue;
        const std::string found = difference(*one, *other, place + "/" + key);
        if (!found.empty()) return found;
    }
    return "";
}

Json report(const std::vector<Ball>& balls, const AnalysisConfig& config) {
    return json_report(analyse(layer_of(balls, config), config), config);
}

/// What does not hang on where the grid begins.
Json without_grid(Json report) {
    for (const char* key : {"phi_exact", "phi_centre", "height", "density_pores", "voxel", "maps"}) report.erase(key);
    for (const char* rule : {"A", "P"}) {
        if (!report["chamber_pores"].contains(rule)) continue;
        report["chamber_pores"][rule].erase("circles_x_y_d");
        report["chamber_pores"][rule].erase("circles_x_y_d_persistence");
    }
    return report;
}

/// Statistics that a mirror leaves alone: lists of places in the order of the grid go.
Json without_places(Json report) {
    report.erase("maps");
    for (const char* connectivity : {"4", "8"}) report["density_pores"][connectivity].erase("pores");
    for (const char* rule : {"A", "P"}) {
        if (!report["chamber_pores"].contains(rule)) continue;
        report["chamber_pores"][rule].erase("circles_x_y_d");
        report["chamber_pores"][rule].erase("circles_x_y_d_persistence");
    }
    return report;
}

struct Kind {
    bool equal_radii;
    double length, width;
};

/// Layers of equal and of unequal spheres, with cells that fit and with such that do not.
class Invariance : public ::testing::TestWithParam<Kind> {
protected:
    void SetUp() override {
        config_ = unit_config(GetParam().length, GetParam().width);
        config_.voxels_per_dp = {9};  // no voxel has its centre on the edge of a window
        balls_ = random_balls(90, GetParam().length, GetParam().width, 17);
        for (Ball& ball : balls_) {
            ball.z = 0.3 + 0.4 * ball.z;
            if (GetParam().equal_radii) ball.radius = 0.45;
        }
        here_ = report(balls_, config_);
    }

    [[nodiscard]] std::vector<Ball> changed(const std::function<void(Ball&)>& change) const {
        std::vector<Ball> result = balls_;
        for (Ball& ball : result) change(ball);
        return result;
    }

    AnalysisConfig config_;
    std::vector<Ball> balls_;
    Json here_;
};

TEST_P(Invariance, OfAShiftOfTheFrame) {
    for (const double shift : {0.123456789, -3.7, 41.4}) {
        AnalysisConfig moved = config_;
        moved.y_min = shift;
        moved.x_begin += 2 * shift;
        moved.x_end += 2 * shift;
        const Json there = report(changed([shift](Ball& ball) { ball.y += shift, ball.x += 2 * shift; }), moved);
        EXPECT_EQ(difference(here_, there), "") << shift;
    }
}

TEST_P(Invariance, OfWholePeriods) {
    int turn = 0;
    const Json there = report(changed([&](Ball& ball) { ball.y += (turn++ % 5 - 2) * config_.y_period; }), config_);
    EXPECT_EQ(difference(here_, there), "");
}

TEST_P(Invariance, OfAShiftAlongThePeriodWhateverTheGrid) {
    for (const double shift : {0.123456789, 2.71, -0.5}) {
        const Json there = report(changed([shift](Ball& ball) { ball.y += shift; }), config_);
        EXPECT_EQ(difference(without_grid(here_), without_grid(there)), "") << shift;
    }
}

TEST_P(Invariance, OfAShiftByWholeCells) {
    const double cell = testing::fitted(config_.y_period, 1);
    const Json there = report(changed([cell](Ball& ball) { ball.y += 2 * cell; }), config_);
    Json here = without_places(here_), moved = without_places(there);
    here.erase("voxel");  // a cell need not be whole voxels
    moved.erase("voxel");
    EXPECT_EQ(difference(here, moved), "");
}

TEST_P(Invariance, OfMirrors) {
    const double length = config_.x_end;
    const Json across = report(changed([](Ball& ball) { ball.y = -ball.y; }), config_);
    EXPECT_EQ(difference(without_places(here_), without_places(across)), "");
    // Pixels, squares that fit the period, begin at the start of the region.
    const std::vector<Ball> mirrored = changed([length](Ball& ball) { ball.x = length - ball.x; });
    Json here = without_places(here_), along = without_places(report(mirrored, config_));
    for (Json* one : {&here, &along}) {
        for (const char* key : {"chamber_P", "chamber_P_errors"}) (*one)["voxel"]["9"].erase(key);
    }
    EXPECT_EQ(difference(here, along), "");
}

TEST_P(Invariance, OfTheUnitOfLength) {
    for (const double unit : {5e-5, 6.7e-5, 2.54e-2}) {
        AnalysisConfig scaled = config_;
        for (double* value : {&scaled.particle_diameter, &scaled.clearance, &scaled.x_end, &scaled.y_period})
            *value *= unit;
        const Json there = report(changed([unit](Ball& ball) {
                                      ball = {ball.x * unit, ball.y * unit, ball.z * unit, ball.radius * unit};
                                  }),
                                  scaled);
        Json here = here_, other = there;
        for (Json* totals : {&here["totals"], &other["totals"]}) {
            totals->erase("mass_per_area");
            totals->erase("mass_per_area_clipped");
        }
        EXPECT_EQ(difference(here, other), "") << unit;
        EXPECT_NEAR(there["totals"]["mass_per_area"].get<double>() / unit, here_["totals"]["mass_per_area"], 1e-9);
        EXPECT_NEAR(there["totals"]["volume_clipped_m3"].get<double>() / (unit * unit * unit),
                    here_["totals"]["volume_clipped_m3"], 1e-9);
    }
}

INSTANTIATE_TEST_SUITE_P(Layers, Invariance,
                         ::testing::Values(Kind{true, 9, 6}, Kind{true, 9.37, 5.61}, Kind{false, 9.37, 5.61}));

}  // namespace
}  // namespace recoat
