#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "common/vec3.hpp"

namespace recoat {

class OutputFile;

/// All particles at one time.
struct State {
    double time = 0;                                     ///< [s]
    std::int64_t step = 0;                               ///< time steps since the start of the run
    std::vector<std::int64_t> id;                        ///< [N] identity, constant through the run
    std::vector<Vec3> position;                          ///< [N] centres [m]
    std::vector<Vec3> velocity;                          ///< [N] [m/s]; empty where it is not known
    std::vector<Vec3> angular_velocity;                  ///< [N] [rad/s]; empty where it is not known
    std::vector<double> radius;                          ///< [N] [m]
    std::map<std::string, std::vector<double>> scalars;  ///< further values, [N] each, e.g. "CoordinationNumber"

    [[nodiscard]] std::size_t size() const { return position.size(); }
};

/// What a state file says about the run that made it. SI units; NaN where a value does not apply.
struct StateInfo {
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    std::int64_t schema_version = 1;
    std::string program_version;       ///< as program_version()
    std::string config;                ///< resolved configuration, YAML
    std::string backend;               ///< what computed it, e.g. "openmp"
    std::string stage;                 ///< name of the stage that ended or is running
    std::int64_t seed = 0;             ///< of the random placement
    double diameter = unknown;         ///< d_p [m]
    double density = unknown;          ///< of the particles [kg/m3]
    double y_min = unknown;            ///< start of the periodic cell [m]
    double y_period = unknown;         ///< length of the periodic cell [m]
    double clearance = unknown;        ///< height of the blade above the base h_b [m]
    double blade_start = unknown;      ///< x of the rear bottom edge of the blade before spreading [m]
    double spread_length = unknown;    ///< way of the blade [m]
    double layer_end = unknown;        ///< x up to which the layer is as the blade left it, at rest [m]
    double bond_number = unknown;      ///< [-]
    double hamaker = unknown;          ///< A^O [J]
    double stiffness_ratio = unknown;  ///< Y^R/Y^O [-]
    double time_step = unknown;        ///< [s]
};

/// Arrays that a file of states may be without: those of files of other codes need not be known.
struct StateArrays {
    bool velocity = true, angular_velocity = true;
};

/// Writes states, one after the other, to a VTKHDF PolyData file (version 2.0) that ParaView 5.12 opens as it is.
///
/// The file has a temporary name until close(); without close() nothing appears under `path`. Point data: Id, Radius,
/// Velocity, AngularVelocity (unless `arrays` leaves them out) and the scalars, which must be the same for all states
/// of a file. The number of particles may change. Throws InputError when the file cannot be written.
class StateWriter {
public:
    StateWriter(const std::filesystem::path& path, const StateInfo& info, StateArrays arrays = {});
    ~StateWriter();
    StateWriter(StateWriter&&) noexcept;
    StateWriter& operator=(StateWriter&&) noexcept;

    /// Adds a state and flushes it. Throws std::invalid_argument when its arrays differ in length.
    void append(const State& state);
    /// Finishes the file and gives it its name.
    void close();

private:
    struct File;
    std::unique_ptr<OutputFile> output_;
    std::unique_ptr<File> file_;  // closed before the output is renamed or removed
};

/// Writes a file with the one state; velocities where it has them.
void write_state(const std::filesystem::path& path, const StateInfo& info, const State& state);

/// State number `index` of a file, counted from 0; negative: from the end. Throws InputError when there is none, or the
/// file is no state file of ours or is damaged.
State read_state(const std::filesystem::path& path, int index = -1);

/// Number of states in a file.
std::size_t count_steps(const std::filesystem::path& path);

/// What the file says about its run.
StateInfo read_state_info(const std::filesystem::path& path);

/// Whether the file is HDF5 with our /recoat group, without reading further.
bool is_state_file(const std::filesystem::path& path);

}  // namespace recoat
