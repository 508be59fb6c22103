#include "solver/sweep_file.hpp"

#include <array>
#include <map>
#include <string_view>

#include "common/config.hpp"
#include "common/error.hpp"
#include "solver/scene/read_scene.hpp"

namespace recoat {
namespace {

namespace fs = std::filesystem;

/// The scene of `entry`; what is wrong with it is said with the place of the case.
Scene scene_of_case(const Config& entry, const std::string& file, const fs::path& folder) {
    const std::vector<std::string> settings = entry.has("set") ? entry.texts("set") : std::vector<std::string>{};
    try {
        return load_scene(folder / file, settings);
    } catch (const InputError& error) {
        entry.fail("", error.what());
    }
}

std::string text_of_case(const Config& entry, const std::string& key) {
    std::string text = entry.text(key);
    if (text.empty()) entry.fail(key, "the text is empty; name a file or folder");
    return text;
}

SweepCase read_case(const Config& sweep, const Config& entry, const fs::path& folder) {
    constexpr std::array<std::string_view, 3> keys = {"out", "set", "scene"};
    entry.allow_only(keys);
    SweepCase result;
    result.name = text_of_case(entry, "out");
    result.folder = folder / result.name;
    if (!entry.has("scene") && !sweep.has("scene"))
        entry.fail("scene", "the key is missing; name a scene here, or one for all cases at the top of the file");
    const std::string scene = text_of_case(entry.has("scene") ? entry : sweep, "scene");
    result.scene = scene_of_case(entry, scene, folder);
    return result;
}

}  // namespace

std::vector<SweepCase> read_sweep(const fs::path& file) {
    const Config sweep = Config::load(file);
    constexpr std::array<std::string_view, 2> keys = {"scene", "cases"};
    sweep.allow_only(keys);
    if (sweep.has("scene")) (void)text_of_case(sweep, "scene");
    std::vector<SweepCase> cases;
    std::map<fs::path, std::string> places;
    const std::vector<Config> entries = sweep.list("cases");
    if (entries.empty()) sweep.fail("cases", "the list is empty; give at least one case");
    for (const Config& entry : entries) {
        cases.push_back(read_case(sweep, entry, file.parent_path()));
        // A trailing slash is no other folder.
        const fs::path place = fs::weakly_canonical(fs::absolute(cases.back().folder / "."));
        const auto [other, added] = places.emplace(place, entry.path());
        if (!added) entry.fail("out", "this folder is that of " + other->second + " too; give each case its own");
    }
    sweep.finish();
    return cases;
}

}  // namespace recoat
