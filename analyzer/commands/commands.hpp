#pragma once

namespace CLI {
class App;
}

namespace recoat {

/// Each adds a command to the program; it runs when the command line that names it is parsed, and throws what
/// run_program() knows.
void add_metrics_command(CLI::App& app);
void add_convergence_command(CLI::App& app);
void add_describe_command(CLI::App& app);
void add_convert_command(CLI::App& app);

}  // namespace recoat
