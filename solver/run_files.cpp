#include "solver/run_files.hpp"

#include "solver/output/trajectory.hpp"

namespace recoat {
namespace fs = std::filesystem;

std::vector<std::string> missing_of_finished(const Scene& scene, const fs::path& folder) {
    std::vector<std::string> names;
    for (const Stage& stage : scene.stages) names.push_back(stage.name + ".vtkhdf");
    if (scene.output.trajectory_interval > 0) names.emplace_back("trajectory.vtkhdf");
    names.emplace_back("walls.vtkhdf");
    if (scene.output.energy_interval > 0) names.emplace_back("energy.csv");
    std::erase_if(names, [&](const std::string& name) { return fs::exists(folder / name); });
    return names;
}

MissingFiles missing_files(const Scene& scene, const fs::path& folder, const RunProgress& progress) {
    MissingFiles missing;
    const bool at_its_end = progress.segment == 0 && progress.segment_steps == 0 && !progress.segment_entered;
    for (std::size_t k = 0; k < progress.stage && k < scene.stages.size(); ++k) {
        const std::string name = scene.stages[k].name + ".vtkhdf";
        if (fs::exists(folder / name)) continue;
        if (k + 1 == progress.stage && at_its_end) {
            missing.last_state = true;
        } else {
            missing.states.push_back(name);
        }
    }
    missing.frames = Trajectory(folder).missing(progress.frames.size());
    return missing;
}

std::string list_of(const std::vector<std::string>& names) {
    if (names.size() > 3) return names.front() + " and " + std::to_string(names.size() - 1) + " more";
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i)
        text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
    return text;
}

}  // namespace recoat
