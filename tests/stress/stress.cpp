#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>
#include <unistd.h>

#include "common/error.hpp"
#include "common/output_file.hpp"
#include "tests/stress/case.hpp"
#include "tests/stress/run_case.hpp"
#include "tests/stress/tally.hpp"
#include "tests/stress/verdict.hpp"

namespace {

namespace fs = std::filesystem;
using namespace recoat;
using namespace recoat::stress;

struct Arguments {
    std::uint64_t seed = 1, scenes = 100, first = 0;
    double seconds = 60;  ///< that a scene may take
    double share = 0.05;  ///< of scenes that run in the real program
    bool keep = false;
    std::string program, out;
};

/// Runs and judges one scene; leaves its folder when it went wrong.
void try_scene(const Arguments& arguments, std::uint64_t index, const fs::path& place, Tally& tally) {
    const fs::path folder = place / ("scene-" + std::to_string(index));
    fs::create_directories(folder);
    const Case scene = draw_case(arguments.seed, index);
    write_case(scene, folder);
    // The factor spreads the chosen ones over the scenes.
    const bool outside =
        !arguments.program.empty() && static_cast<double>(index * 7919 % 1000) < 1000 * arguments.share;
    const int threads = index % 4 == 0 ? 2 : 1;
    const stress::Ending ending = run_case(folder, threads, arguments.seconds,
                                           outside ? std::optional<fs::path>(arguments.program) : std::nullopt);
    const Verdict verdict = judge(ending, folder);
    tally.add(index, scene, verdict);
    if (!is_right(verdict.outcome) || arguments.keep) {
        const fs::path kept = fs::path(arguments.out) / folder.filename();
        fs::create_directories(arguments.out);
        fs::remove_all(kept);
        fs::copy(folder, kept, fs::copy_options::recursive);
    }
    fs::remove_all(folder);
}

int try_all(const Arguments& arguments) {
    std::string pattern = (fs::temp_directory_path() / "recoat-stress-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) throw InputError("no temporary folder can be made; set TMPDIR");
    Tally tally;
    for (std::uint64_t k = 0; k < arguments.scenes; ++k) try_scene(arguments, arguments.first + k, pattern, tally);
    fs::remove_all(pattern);
    write_text_file(fs::path(arguments.out) / "tally.json", tally.json(arguments.seed));
    write_text_file(fs::path(arguments.out) / "tally.md", tally.markdown(arguments.seed));
    std::fputs(tally.markdown(arguments.seed).c_str(), stdout);
    if (tally.failures() > 0)
        std::fprintf(stderr, "stress: %lld scenes went wrong\n", static_cast<long long>(tally.failures()));
    const std::optional<std::string> one_sided = tally.one_sided();
    if (one_sided) std::fprintf(stderr, "stress: %s\n", one_sided->c_str());
    return tally.failures() == 0 && !one_sided ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    Arguments arguments;
    CLI::App app("Runs random scenes and judges how each one ends", "stress");
    app.add_option("--seed", arguments.seed, "Of the scenes");
    app.add_option("--scenes", arguments.scenes, "How many");
    app.add_option("--first", arguments.first, "Number of the first scene, to run one of them again");
    app.add_option("--seconds", arguments.seconds, "That a scene may take");
    app.add_option("--program", arguments.program, "recoat-solve, for a share of the scenes")->check(CLI::ExistingFile);
    app.add_option("--share", arguments.share, "Of scenes that run in that program");
    app.add_flag("--keep", arguments.keep, "Keep the folder of every scene, not only of those that went wrong");
    app.add_option("--out", arguments.out, "Folder for the tally and for scenes that went wrong")->required();
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    return recoat::run_program("stress", [&] { return try_all(arguments); });
}
