#include "solver/run_ending.hpp"

#include <fmt/format.h>

#include "common/readable.hpp"
#include "solver/run_files.hpp"

namespace recoat {
namespace {

std::string made(const Scene& scene, const RunProgress& progress) {
    std::vector<std::string> names;
    for (const Stage& stage : scene.stages) names.push_back(stage.name + ".vtkhdf");
    std::string text =
        list_of(names) + (names.size() == 1 ? " (the state after its stage)" : " (the states after each stage)");
    if (!progress.frames.empty())
        text += fmt::format(", trajectory.vtkhdf ({} states)",
                            readable_count(static_cast<long long>(progress.frames.size())));
    text += ", walls.vtkhdf";
    if (!progress.energy.empty()) text += ", energy.csv";
    return text + " and summary.json";
}

/// Stages that might have come to rest and did not.
std::string restless(const Scene& scene, const RunProgress& progress) {
    std::vector<std::string> names;
    for (std::size_t k = 0; k < progress.finished.size() && k < scene.stages.size(); ++k) {
        if (scene.stages[k].may_end_early() && !progress.finished[k].settled) names.push_back(scene.stages[k].name);
    }
    if (names.empty()) return {};
    return fmt::format("\nNot at rest when the settle_time was over: {}; a longer one lets the particles come to rest.",
                       list_of(names));
}

}  // namespace

std::string quoted(const std::filesystem::path& path) {
    const std::string text = path.string();
    return text.find_first_of(" '\"$&();*?") == std::string::npos ? text : "\"" + text + "\"";
}

std::string stage_ending(const Stage& stage, const StageRecord& record) {
    std::string text = fmt::format("{}: {} {} ({})", record.name, readable_count(record.steps),
                                   record.steps == 1 ? "step" : "steps", readable(record.time, "s"));
    if (!stage.may_end_early()) return text + ".";
    return text + (record.settled ? ", settled." : ", not at rest yet when its settle_time was over.");
}

std::string run_ending(const Scene& scene, const RunProgress& progress, const std::filesystem::path& folder) {
    const std::string last = quoted(folder / (scene.stages.back().name + ".vtkhdf"));
    const std::string next =
        scene.spread && scene.spread->length > 0 ? "recoat-analyze metrics " + last : "recoat-analyze describe " + last;
    return fmt::format("Finished. In {}: {}.{}\nNext: {}", folder.string(), made(scene, progress),
                       restless(scene, progress), next);
}

}  // namespace recoat
