#include "tests/stress/run_case.hpp"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "common/error.hpp"
#include "solver/run.hpp"
#include "solver/scene/read_scene.hpp"

namespace recoat::stress {
namespace {

namespace fs = std::filesystem;

void redirect_errors(const fs::path& file) {
    const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    ::dup2(descriptor, STDERR_FILENO);
    const rlimit none{0, 0};
    ::setrlimit(RLIMIT_CORE, &none);
}

int run_inside(const fs::path& folder, int threads) {
    return run_program("recoat-solve", [&] {
        const Scene scene = load_scene(folder / "scene.yaml");
        RunOptions options;
        options.folder = folder / "out";
        options.resources.threads = threads;
        options.quiet = true;
        return run_scene(scene, options, EngineFactory{make_engine, restore_engine});
    });
}

[[noreturn]] void be_child(const fs::path& folder, int threads, const std::optional<fs::path>& program) {
    redirect_errors(folder / "errors.txt");
    if (!program) std::_Exit(run_inside(folder, threads));
    const std::string scene = folder / "scene.yaml", out = folder / "out", count = std::to_string(threads);
    ::execl(program->c_str(), "recoat-solve", "run", scene.c_str(), "--out", out.c_str(), "--threads", count.c_str(),
            "--quiet", nullptr);
    std::_Exit(127);
}

/// Status of `child`, killed after `seconds`.
int wait_for(pid_t child, double seconds, bool& hung) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    int status = 0;
    while (::waitpid(child, &status, WNOHANG) == 0) {
        if (!hung && std::chrono::steady_clock::now() > end) {
            hung = true;
            ::kill(child, SIGKILL);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return status;
}

}  // namespace

Ending run_case(const fs::path& folder, int threads, double seconds, const std::optional<fs::path>& program) {
    const pid_t child = ::fork();
    if (child < 0) throw std::runtime_error("no further process can be started");
    if (child == 0) be_child(folder, threads, program);
    Ending ending;
    const int status = wait_for(child, seconds, ending.hung);
    ending.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    std::ifstream stream(folder / "errors.txt");
    ending.sentence.assign(std::istreambuf_iterator<char>(stream), {});
    return ending;
}

}  // namespace recoat::stress
