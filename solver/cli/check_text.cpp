#include "solver/cli/check_text.hpp"

#include <cstdint>

#include <fmt/format.h>

#include "common/readable.hpp"

namespace recoat {
namespace {

using Json = nlohmann::ordered_json;

std::string row(const std::string& name, const std::string& value) { return fmt::format("  {:<46} {}\n", name, value); }

std::string row(const std::string& name, const Json& value, const std::string& unit) {
    if (value.is_null()) return row(name, "infinite");
    if (value.is_number_integer()) return row(name, readable_count(value.get<std::int64_t>()));
    return row(name, readable(value.get<double>(), unit));
}

std::string material_text(const Json& r) {
    std::string text = "Particles\n" + row("number", r["particles"], "");
    text += row("diameter d_p", r["diameter"], "m") + row("mass m", r["mass"], "kg");
    text += row("moment of inertia I", r["inertia"], "kg m2") + row("weight m g", r["weight"], "N");
    text += "Stiffness\n" + row("stiffness ratio Y^R/Y^O", r["stiffness_ratio"], "");
    for (const char* partner : {"pair", "wall"}) {
        for (const char* form : {"original", "reduced"}) {
            const std::string what = fmt::format(" {}, {}", partner, form);
            text += row("E*" + what, r["effective_modulus"][partner][form], "Pa");
            text += row("G*" + what, r["effective_shear_modulus"][partner][form], "Pa");
        }
    }
    return text + row("damping coefficient beta", r["damping_coefficient"], "");
}

std::string sizes_text(const Json& r) {
    if (!r.contains("sizes")) return {};
    const Json& s = r["sizes"];
    std::string text =
        "Sizes (mass, weight, cohesion and inertial length below are those of a sphere of diameter d_p)\n";
    text += row("smallest diameter", s["smallest"], "m") + row("largest diameter", s["largest"], "m");
    text += row("mean diameter, by number", s["mean"], "m") + row("Sauter diameter d_32", s["sauter"], "m");
    text += row("median diameter, by number", s["median_by_number"], "m");
    text += row("median diameter, by mass", s["median_by_mass"], "m");
    text += row("Bond number, pair of the smallest", s["bond_number"]["smallest"], "");
    return text + row("Bond number, pair of the largest", s["bond_number"]["largest"], "");
}

std::string cohesion_text(const Json& r) {
    std::string text = "Cohesion\n" + row("Hamaker constant A^O (out of contact)", r["hamaker"]["original"], "J");
    text += row("Hamaker constant A^R (in contact)", r["hamaker"]["reduced"], "J");
    text +=
        row("Bond number, pair", r["bond_number"]["pair"], "") + row("Bond number, wall", r["bond_number"]["wall"], "");
    text += row("pull-off force, pair", r["pull_off_force"]["pair"], "N");
    text += row("pull-off force, wall", r["pull_off_force"]["wall"], "N");
    text += row("inertial length, pull-off force of the pair", r["inertial_length"]["paper"], "d_p");
    return text + row("inertial length, pull-off force of the wall", r["inertial_length"]["wall"], "d_p");
}

std::string time_text(const Json& r) {
    const auto choice = r["time_step_choice"].get<std::string>();
    const std::string by = choice == "given" ? "chosen" : fmt::format("chosen ({})", choice);
    std::string text = "Time step\n" + row(by, r["time_step"], "s");
    for (const Json& limit : r["time_step_limits"]) {
        text += row(limit["name"].get<std::string>(),
                    fmt::format("{}, the step is {:.2f} % of it: {}{}", readable(limit["limit"].get<double>(), "s"),
                                100 * limit["share"].get<double>(), limit["formula"].get<std::string>(),
                                limit["stability"].get<bool>() ? " (stability limit)" : ""));
    }
    if (r.contains("time_step_errors")) {
        const Json& e = r["time_step_errors"];
        const auto percent = [&](const char* key) {
            return fmt::format("within {:.2g} %", 100 * e[key].get<double>());
        };
        text += row("error of the capture velocity", percent("capture_velocity"));
        text += row("error of the rebound from the speed of the scene", percent("rebound"));
        text += row("error of the balance of energy", percent("energy_balance"));
    }
    text += "Stages\n";
    for (const Json& stage : r["stages"]) {
        text += row(stage["name"].get<std::string>(),
                    fmt::format("{} steps, {}{}", readable_count(stage["steps"].get<std::int64_t>()),
                                readable(stage["time"].get<double>(), "s"),
                                stage["may_end_early"].get<bool>() ? " at most" : ""));
    }
    return text;
}

std::string rate_text(const Json& e) {
    if (e["particle_steps_per_second"] == 0) return "none: a block of touching spheres flies apart";
    return fmt::format("{:.3g} particle-steps/s ({} touching spheres, {} {})",
                       e["particle_steps_per_second"].get<double>(), e["measured_particles"].get<std::int64_t>(),
                       e["threads"].get<int>(), e["threads"] == 1 ? "thread" : "threads");
}

std::string output_text(const Json& o) {
    std::string text = readable_bytes(o["bytes"].get<double>());
    const auto states = o["trajectory_states"].get<std::int64_t>();
    if (states > 0)
        text += fmt::format(" ({} states of a trajectory: {})", readable_count(states),
                            readable_bytes(o["trajectory_bytes"].get<double>()));
    if (!o["free_bytes"].is_null())
        text += fmt::format("; the disk has {} free", readable_bytes(o["free_bytes"].get<double>()));
    return text;
}

/// What is made in any case, and what comes on top where stages settle as late as they may.
std::string run_time_text(const Json& e) {
    if (e["particle_steps_per_second"] == 0) return {};
    const auto least = e["seconds_without_settling"].get<double>(), most = e["seconds"].get<double>();
    if (least == most) return row("run time", readable_duration(most));
    return row("run time, while walls move and time is given", readable_duration(least)) +
           row("run time at most, if nothing settles early", readable_duration(most));
}

std::string expectation_text(const Json& r) {
    const Json& e = r["expected"];
    std::string text = "Expected\n" + row("steps at most", r["steps"], "") +
                       row("rate on this machine, measured", rate_text(e)) + run_time_text(e) +
                       row("memory of the particles", readable_bytes(e["bytes"].get<double>())) +
                       row("output at most", output_text(e["output"]));
    if (e["busy"].get<bool>())
        text += fmt::format(
            "  The machine is busy: the measurements got {:.0f} % of the processor's time, so the rate, the "
            "best of them, may be too low.\n",
            100 * e["processor_share"].get<double>());
    return text;
}

std::string notes_text(const Json& r) {
    std::string text;
    for (const Json& note : r["notes"]) text += "Note: " + note.get<std::string>() + ".\n";
    return text;
}

}  // namespace

std::string check_text(const nlohmann::ordered_json& report) {
    return sizes_text(report) + material_text(report) + cohesion_text(report) + time_text(report) +
           expectation_text(report) + notes_text(report);
}

}  // namespace recoat
