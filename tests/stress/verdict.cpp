#include "tests/stress/verdict.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <vector>

#include <nlohmann/json.hpp>

#include "common/error.hpp"
#include "common/hdf5.hpp"
#include "common/number.hpp"
#include "common/state.hpp"
#include "solver/output/checkpoint.hpp"
#include "solver/scene/initial_particles.hpp"
#include "solver/scene/read_scene.hpp"
#include "tests/stress/fault_sentence.hpp"
#include "tests/stress/ledger_check.hpp"

namespace recoat::stress {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

Verdict wrong(Outcome outcome, const std::string& reason) { return {outcome, reason, 0, 0, 0}; }

bool finite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// What is wrong with the states of a file.
std::optional<Verdict> bad_states(const fs::path& file, std::size_t particles) {
    for (std::size_t s = 0; s < count_steps(file); ++s) {
        const State state = read_state(file, static_cast<int>(s));
        if (state.size() != particles)
            return wrong(Outcome::lost,
                         file.filename().string() + " has " + std::to_string(state.size()) + " particles");
        for (std::size_t i = 0; i < particles; ++i) {
            if (!finite(state.position[i]) || !finite(state.velocity[i]) || !finite(state.angular_velocity[i]))
                return wrong(Outcome::not_finite, file.filename().string() + ", particle " + std::to_string(i));
        }
    }
    return {};
}

/// What is wrong with the walls as they are drawn.
std::optional<Verdict> bad_walls(const fs::path& file) {
    const auto points = hdf5::File::open(file).group("VTKHDF").read<double>("Points");
    if (std::ranges::all_of(points, [](double value) { return std::isfinite(value); })) return {};
    return wrong(Outcome::not_finite, file.filename().string() + ", a corner");
}

/// What is wrong with any file of a run.
std::optional<Verdict> bad_files(const fs::path& out, std::size_t particles) {
    if (!fs::exists(out)) return {};
    for (const auto& entry : fs::recursive_directory_iterator(out)) {
        const fs::path& file = entry.path();
        if (file.extension() == ".part") return wrong(Outcome::lost, "a temporary file stays: " + file.string());
        if (file.filename() == "walls.vtkhdf") {
            if (auto bad = bad_walls(file)) return bad;
        } else if (file.extension() == ".vtkhdf") {
            if (auto bad = bad_states(file, particles)) return bad;
        }
        if (file.filename() == "checkpoint.h5") static_cast<void>(read_checkpoint(file));
        if (file.extension() == ".csv" || file.extension() == ".json") {
            const std::string text = text_of(file);
            for (const char* word : {"nan", "inf,", "inf\n", "null"}) {
                if (text.find(word) != std::string::npos)
                    return wrong(Outcome::not_finite, file.filename().string() + " has " + word);
            }
        }
    }
    return {};
}

bool is_one_sentence(const std::string& text) {
    return text.starts_with("recoat-solve: error: ") && std::ranges::count(text, '\n') == 1;
}

/// A run that stopped must say at which step which particle did what to whom, and leave the moment before.
Verdict judge_stopped(const Ending& ending, const Scene& scene, const fs::path& out) {
    const fs::path file = out / "fault.vtkhdf";
    if (!fs::exists(file)) return wrong(Outcome::no_state, ending.sentence);
    std::vector<std::string> walls;
    for (const Wall& wall : scene.walls) walls.push_back(wall.name);
    if (const auto problem = unusable(ending.sentence, read_state(file), walls, scene.y_period))
        return wrong(Outcome::bad_sentence, *problem + ": " + ending.sentence);
    return {Outcome::stopped, ending.sentence, 0, 0, 0};
}

Verdict judge_finished(const Scene& scene, const ParticleTable& start, const fs::path& out) {
    const auto summary = nlohmann::json::parse(text_of(out / "summary.json"));
    if (summary.at("status") != "finished") return wrong(Outcome::no_state, "the summary does not say finished");
    if (summary.at("particles") != start.size() || summary.at("particles_lost") != 0)
        return wrong(Outcome::lost, "summary.json: " + summary.at("particles_lost").dump() + " lost");
    Verdict verdict;
    if (start.size() == 0) return verdict;
    const double overlap = summary.at("stages").back().at("largest_overlap").get<double>() * scene.diameter;
    const LedgerCheck ledger = check_ledger(scene, out / "energy.csv", summary.at("steps"), overlap, start);
    verdict.ledger_error = ledger.error;
    verdict.ledger_bound = ledger.bound;
    verdict.step = ledger.step;
    if (!(ledger.error <= ledger.bound)) {
        verdict.outcome = Outcome::open_ledger;
        verdict.reason = "energy off by " + shortest(ledger.error) + " of what was exchanged, at most " +
                         shortest(ledger.bound) + " expected";
    }
    return verdict;
}

}  // namespace

std::string name_of(Outcome outcome) {
    constexpr std::array<const char*, 10> names = {
        "finished",          "stopped with a sentence (3)", "refused with a sentence (2)", "crash", "hang",
        "unusable sentence", "no state of the fault",       "number not finite",           "loss",  "ledger open"};
    return names[static_cast<std::size_t>(outcome)];
}

Verdict judge(const Ending& ending, const fs::path& folder) {
    if (ending.hung) return wrong(Outcome::hang, "killed after its time");
    if (ending.code != 0 && ending.code != 2 && ending.code != 3)
        return wrong(Outcome::crash, "exit code " + std::to_string(ending.code) + ": " + ending.sentence);
    if (ending.code != 0 && !is_one_sentence(ending.sentence)) return wrong(Outcome::bad_sentence, ending.sentence);
    if (ending.code == 2) return {Outcome::refused, ending.sentence, 0, 0, 0};
    const fs::path out = folder / "out";
    try {
        const Scene scene = load_scene(folder / "scene.yaml");
        const ParticleTable start = initial_particles(scene);
        if (auto bad = bad_files(out, start.size())) return *bad;
        return ending.code == 3 ? judge_stopped(ending, scene, out) : judge_finished(scene, start, out);
    } catch (const std::exception& error) {
        return wrong(Outcome::no_state, std::string("an output cannot be read: ") + error.what());
    }
}

}  // namespace recoat::stress
