#include "analyzer/output/plots.hpp"

#include <cerrno>
#include <cstdlib>
#include <vector>

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "analyzer/output/particle_file.hpp"
#include "common/error.hpp"
#include "common/output_file.hpp"

namespace recoat {
namespace {

namespace fs = std::filesystem;

/// A folder for what passes between the programs, which goes with its object.
class PassingFolder {
public:
    PassingFolder() {
        std::string pattern = (fs::temp_directory_path() / "recoat-plots-XXXXXX").string();
        if (::mkdtemp(pattern.data()) == nullptr)
            throw InputError(fmt::format("--plots: {} cannot be made; free some space there", pattern));
        path_ = pattern;
    }
    ~PassingFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    PassingFolder(const PassingFolder&) = delete;
    PassingFolder& operator=(const PassingFolder&) = delete;
    [[nodiscard]] const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

std::string python() {
    if (const char* chosen = std::getenv("RECOAT_PYTHON")) return chosen;
    const fs::path beside = fs::path(RECOAT_SOURCE_FOLDER) / ".venv/bin/python";
    return fs::exists(beside) ? beside.string() : "python3";
}

fs::path script() {
    const char* chosen = std::getenv("RECOAT_SCRIPTS");
    const fs::path folder = chosen != nullptr ? fs::path(chosen) : fs::path(RECOAT_SOURCE_FOLDER) / "workflow/scripts";
    fs::path file = folder / "plot_layer.py";
    if (fs::exists(file)) return file;
    throw InputError(fmt::format(
        "--plots: {} is not there; set RECOAT_SCRIPTS to the folder workflow/scripts of Recoat", file.string()));
}

/// Exit status of a program found along PATH; 127 where it cannot be started.
int run(const std::vector<std::string>& words) {
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    pid_t child = 0;
    if (::posix_spawnp(&child, arguments[0], nullptr, nullptr, arguments.data(), environ) != 0) return 127;
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

std::string content_of(const fs::path& file) {
    std::string text;
    if (FILE* stream = std::fopen(file.c_str(), "r")) {
        for (int letter = std::fgetc(stream); letter != EOF && letter != '\n'; letter = std::fgetc(stream))
            text += static_cast<char>(letter);
        (void)std::fclose(stream);
    }
    return text;
}

}  // namespace

void draw_plots(const fs::path& folder, const std::string& report, const Source& source) {
    const PassingFolder passing;
    const fs::path state = passing.path() / "layer.vtkhdf", json = passing.path() / "layer.json",
                   reason = passing.path() / "reason.txt";
    const std::string interpreter = python();
    const fs::path program = script();
    write_particle_file(state, "vtkhdf", source);
    write_text_file(json, report);
    const int status =
        run({interpreter, program.string(), json.string(), state.string(), folder.string(), reason.string()});
    if (status == 0) return;
    if (status == 127) {
        throw InputError(fmt::format(
            "--plots: the Python \"{}\" cannot be started; run ./setup.sh, or set RECOAT_PYTHON to one", interpreter));
    }
    const std::string said = content_of(reason);
    throw InputError(fmt::format(
        "--plots: {}", said.empty() ? fmt::format("{} failed with status {}", program.string(), status) : said));
}

}  // namespace recoat
