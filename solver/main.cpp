#include <algorithm>
#include <cstdio>
#include <thread>

#include "common/command_line.hpp"
#include "common/error.hpp"
#include "common/version.hpp"
#include "solver/cli/brief_waiting.hpp"
#include "solver/cli/check.hpp"
#include "solver/cli/choose_resources.hpp"
#include "solver/cli/models.hpp"
#include "solver/cli/share_cores.hpp"
#include "solver/run.hpp"
#include "solver/scene/read_scene.hpp"
#include "solver/stop_request.hpp"
#include "solver/sweep.hpp"

namespace {

using namespace recoat;

constexpr int most_threads = 1024;

struct Arguments {
    std::string scene, out, folder, sweep;
    std::vector<std::string> settings;
    ResourceRequest resources;
    bool quiet = false, overwrite = false, print_config = false, json = false;
    std::optional<std::int64_t> until_step;
    int jobs = 0;
};

const EngineFactory real_engine{make_engine, restore_engine};

Resources resources_of(const Arguments& arguments) {
    const ResourceChoice choice = choose_resources(
        arguments.resources, arguments.resources.backend == "cpu" ? Devices{} : cuda_devices(), try_device);
    if (!choice.notice.empty()) std::fprintf(stderr, "recoat-solve: note: %s\n", choice.notice.c_str());
    return choice.resources;
}

RunOptions run_options(const Arguments& arguments, const std::string& folder) {
    RunOptions options;
    options.folder = folder;
    options.resources = resources_of(arguments);
    options.quiet = arguments.quiet;
    options.overwrite = arguments.overwrite;
    options.until_step = arguments.until_step;
    return options;
}

int run(const Arguments& arguments) {
    const Scene scene = load_scene(arguments.scene, arguments.settings);
    if (arguments.print_config) {
        std::fputs(scene.resolved.c_str(), stdout);
        return 0;
    }
    if (arguments.out.empty())
        throw InputError("--out is missing; name the folder for the results, e.g. --out results");
    listen_for_stop();
    return run_scene(scene, run_options(arguments, arguments.out), real_engine);
}

int resume(const Arguments& arguments) {
    listen_for_stop();
    return resume_run(run_options(arguments, arguments.folder), real_engine);
}

int sweep(const Arguments& arguments) {
    const std::vector<SweepCase> cases = read_sweep(arguments.sweep);
    SweepOptions options;
    options.resources = resources_of(arguments);
    const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    const Share share = share_cores({arguments.jobs, arguments.resources.threads}, static_cast<int>(cases.size()),
                                    cores, options.resources.backend);
    options.resources.threads = share.threads;
    options.jobs = share.jobs;
    options.quiet = arguments.quiet;
    options.overwrite = arguments.overwrite;
    listen_for_stop();
    const std::vector<CaseEnding> endings = run_sweep(cases, options, real_engine);
    std::fputs(sweep_report(endings).c_str(), stdout);
    return exit_code(endings);
}

int check(const Arguments& arguments) {
    const Scene scene = load_scene(arguments.scene, arguments.settings);
    const Resources resources = resources_of(arguments);
    std::fputs(check_report(scene, resources, arguments.out, arguments.json, real_engine).c_str(), stdout);
    return 0;
}

void add_scene(CLI::App& command, Arguments& arguments) {
    command.add_option("scene", arguments.scene, "Scene file (YAML)")->required();
    command.add_option("--set", arguments.settings, "Replace a value of the scene: a.b=v (may be repeated)")
        ->allow_extra_args(false);
}

void add_quiet(CLI::App& command, Arguments& arguments) {
    command.add_flag("--quiet", arguments.quiet, "No progress on standard error");
}

void add_overwrite(CLI::App& command, Arguments& arguments) {
    command.add_flag("--overwrite", arguments.overwrite,
                     "Replace a run of another configuration, instead of refusing; a run of this one is continued");
}

void add_progress(CLI::App& command, Arguments& arguments) {
    add_quiet(command, arguments);
    command.add_option("--until-step", arguments.until_step, "Stop at this step with a checkpoint")
        ->check(whole_number(0));
}

void add_resources(CLI::App& command, Arguments& arguments,
                   const char* threads = "Threads (default: all cores); results do not depend on it") {
    command.add_option("--threads", arguments.resources.threads, threads)->check(whole_number(1, most_threads));
    command
        .add_option("--backend", arguments.resources.backend,
                    "Where to compute: cpu, cuda, or auto for a CUDA device where there is one (default)")
        ->check(CLI::IsMember({"auto", "cpu", "cuda"}));
    command.add_option("--device", arguments.resources.device, "Number of the CUDA device (default: 0)")
        ->check(whole_number(0, 1023));
}

void add_commands(CLI::App& app, Arguments& arguments) {
    CLI::App& run_command = *app.add_subcommand("run", "Run a scene");
    add_scene(run_command, arguments);
    run_command.add_option("--out", arguments.out, "Folder for states, checkpoint and summary");
    add_overwrite(run_command, arguments);
    run_command.add_flag("--print-config", arguments.print_config, "Print the scene with all defaults and stop");
    add_progress(run_command, arguments);
    add_resources(run_command, arguments);

    CLI::App& resume_command = *app.add_subcommand("resume", "Continue an interrupted run");
    resume_command.add_option("folder", arguments.folder, "Folder of the run")->required();
    add_progress(resume_command, arguments);
    add_resources(resume_command, arguments);

    CLI::App& sweep_command = *app.add_subcommand("sweep", "Run several scenes at the same time, on one device");
    sweep_command.add_option("file", arguments.sweep, "Sweep file (YAML): scene, and cases of {out, set, scene}")
        ->required();
    sweep_command
        .add_option("--jobs", arguments.jobs,
                    "Cases at the same time (default: all on a CUDA device; on the CPU as many as have cores)")
        ->check(whole_number(1, most_threads));
    add_overwrite(sweep_command, arguments);
    add_quiet(sweep_command, arguments);
    add_resources(sweep_command, arguments,
                  "Threads of each case (default: the cores, shared); results do not depend on it");

    CLI::App& check_command =
        *app.add_subcommand("check", "Print derived numbers, time-step limits, expected run time");
    add_scene(check_command, arguments);
    check_command.add_option("--out", arguments.out, "Folder for a run, to see whether its disk has the room");
    check_command.add_flag("--json", arguments.json, "As JSON, in SI units");
    add_resources(check_command, arguments);

    app.add_subcommand("models", "List the options of the model, their meaning and defaults");
}

int dispatch(const CLI::App& app, const Arguments& arguments) {
    if (app.got_subcommand("run")) return run(arguments);
    if (app.got_subcommand("resume")) return resume(arguments);
    if (app.got_subcommand("sweep")) return sweep(arguments);
    if (app.got_subcommand("check")) return check(arguments);
    std::fputs(models_text().c_str(), stdout);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    wait_briefly(argv);
    return run_program("recoat-solve", [&] {
        Arguments arguments;
        CLI::App app("Spreading of cohesive powder by the discrete element method", "recoat-solve");
        app.set_version_flag("--version",
                             "recoat-solve " + program_version() + ", loops for " + name_of(chosen_instruction_set()));
        app.require_subcommand(1);
        add_commands(app, arguments);
        if (const std::optional<int> code = parse_command_line(app, argc, argv)) return *code;
        return dispatch(app, arguments);
    });
}
