#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "common/vec3.hpp"
#include "solver/contact/model.hpp"
#include "solver/engine/engine.hpp"
#include "solver/engine/list_skins.hpp"
#include "solver/engine/wall.hpp"
#include "solver/scene/size_distribution.hpp"
#include "solver/scene/stage.hpp"

namespace recoat {

/// Spheres at random places of a column, not overlapping.
struct ColumnSource {
    std::int64_t count = 0;
    double packing_density = 0.3;  ///< of the column [-]
    double x_lower = 0;            ///< faces of blade and gate [m]
    double x_upper = 0;
    std::int64_t seed = 1;
    std::optional<SizeDistribution> sizes;  ///< none: all have the diameter d_p
};

/// Particles of a CSV table.
struct TableSource {
    std::filesystem::path file;
};

/// The last step of a state file.
struct StateSource {
    std::filesystem::path file;
};

using ParticleSource = std::variant<ColumnSource, TableSource, StateSource>;

/// Where the blade spreads; NaN in scenes without one.
struct SpreadGeometry {
    double clearance = 0;    ///< h_b [m]
    double blade_start = 0;  ///< x of its rear bottom edge before it moves [m]
    double length = 0;       ///< distance that it spreads over, all stages together [m]
    double fill_length = 0;  ///< from blade to gate [m]
    double blade_speed = 0;  ///< [m/s]
};

/// What is written on the way.
struct OutputPlan {
    std::int64_t trajectory_interval = 0;  ///< steps; 0: no trajectory
    std::int64_t energy_interval = 0;      ///< steps; 0: no series
    double checkpoint_interval = 600;      ///< of wall-clock time [s]
};

/// Where the time step comes from [docs/accuracy.md].
enum class TimeStepChoice {
    given,
    automatic,  ///< as long as single contacts and the powder allow
    fast        ///< as long as beds and layers cannot be told from those of shorter steps
};

/// A whole simulation as data, in SI units.
struct Scene {
    std::string kind;                                    ///< spread or particles
    double diameter = 0;                                 ///< d_p: unit of lengths, and sphere of the Bond number [m]
    double smallest_diameter = 0, largest_diameter = 0;  ///< that particles may have [m]
    ContactModel model;
    double bond_number = 0;           ///< of a pair of spheres of diameter d_p under `reference_gravity`
    double gravity = 0;               ///< along -z [m/s2]
    double reference_gravity = 9.81;  ///< that of the Bond number where gravity is off [m/s2]
    double time_step = 0;             ///< [s]
    TimeStepChoice time_step_choice = TimeStepChoice::given;
    ListSkins skins;
    Precision precision = Precision::double_precision;
    bool sleep = true;  ///< particles at rest are left as they are
    std::int64_t seed = 1;
    double y_period = 0;  ///< y runs from 0 to it; 0: not periodic [m]
    Vec3 domain_lower, domain_upper;
    ParticleSource source;
    std::vector<Wall> walls;
    std::vector<Stage> stages;
    std::optional<SpreadGeometry> spread;
    double reference_speed = 0.05;  ///< for the time-step limits [m/s]
    OutputPlan output;
    std::string resolved;            ///< the configuration with all defaults, as YAML
    std::vector<std::string> notes;  ///< what can be run but is probably not meant, a sentence each
};

/// The engine's set-up for `scene`.
EngineSetup engine_setup(const Scene& scene, const Resources& resources);

}  // namespace recoat
